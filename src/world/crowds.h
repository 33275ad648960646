// Bodies in one place, by mistake or for a start. Of n that lie in each other every two overlap, n²/2 pairs, and nobody
// has the time to solve them all. They need not be: who is deep in many others is pushed out by a few of them.
#pragma once

#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

// Takes out of `pairs`, which are ascending by key, those that are too many, and ends their contacts. Two bodies are
// deep in each other where balls inside them overlap by a tenth, which bodies that merely lie on each other never do;
// who is deep in more than eight others is in a crowd. Two of a crowd remain a pair where they are 1, 2, 4, 8, … places
// apart in the list of partners of the one or the other: so n bodies in one place have n log₂ n pairs, and everybody is
// within log₂ n steps of everybody else. Once they are apart, nobody is in a crowd.
void thin_crowds(World::Impl&, std::vector<std::uint32_t>& pairs);

}
