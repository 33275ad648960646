// The step as a table. World::step walks it once a sub-step; order, profile names and hash points come from here. (User
// changes act at once, between steps: a world that is saved between a change and its step then needs no queue.)
#pragma once

#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

void find_pairs(World::Impl&);
void collide(World::Impl&);
void link(World::Impl&);
void solve(World::Impl&);
void meet_fast(World::Impl&);
void refit(World::Impl&);
void sleep(World::Impl&);

struct Stage {
  const char* name;
  void (*run)(World::Impl&);
};

inline constexpr Stage stages[] = {
    {"pairs", find_pairs},  // moved proxies → pairs that began to overlap, sorted
    {"collide", collide},   // pairs, poses → manifolds, begin and end bits
    {"link", link},         // bits in pair order → events, islands, contact rows
    {"solve", solve},       // contacts, joints, forces → velocities, poses
    {"impact", meet_fast},  // ways of fast bodies → what they meet on them, velocities, poses
    {"refit", refit},       // poses → fat boxes, move list
    {"sleep", sleep},       // quiet islands stop
};

}
