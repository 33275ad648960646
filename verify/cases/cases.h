// The table of cases, a function for each file of them.
#pragma once

#include "verify/case.h"

namespace sudar::verify {

std::vector<Case> free_bodies();
std::vector<Case> rotations();
std::vector<Case> pendulums();
std::vector<Case> impacts();
std::vector<Case> bounces();
std::vector<Case> fast();
std::vector<Case> friction();
std::vector<Case> rolling();
std::vector<Case> toppling();
std::vector<Case> stacks();
std::vector<Case> arches();
std::vector<Case> chains();
std::vector<Case> joints();
std::vector<Case> domino_rows();
std::vector<Case> bowls();
std::vector<Case> tops();
std::vector<Case> momentum();
std::vector<Case> grains();
std::vector<Case> silos();
std::vector<Case> solids();
std::vector<Case> simbenchmark();
std::vector<Case> errata();
std::vector<Case> distances();

}
