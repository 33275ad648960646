// How contacts curve: bodies turn and surfaces are round, so that between two sub-steps the relative velocity u of a
// contact point changes by itself, without any impulse.
//
// A velocity that is projected on today's tangent before it carries the body along that tangent loses ω²h of its energy
// a second: a ball slows down that circles in a pipe, a rattleback never turns back. Instead, impulses act at the
// beginning of the sub-step as ever, and what they aim at is u in its middle: bodies then move along the chord, and
// nothing is lost. It is what SHAKE does for joints (Hairer, Lubich, Wanner, Geometric Numerical Integration, VII.1),
// with the manifold in the middle of the sub-step for a constraint. A point that slides resists the slip of the
// beginning, where the impulse acts.
#pragma once

#include "dynamics/sub_step.h"

namespace sudar::inline SUDAR_PRECISION {

// Before collisions: what approaches only because the last sub-step moved it along a chord is no impact.
void look_back(SubStep& s);
// Before the contact passes.
void look_ahead(SubStep& s);

}
