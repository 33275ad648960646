// Whether a body has come to rest, by how far it got in its quiet time, not by its speed: at a turning point speed is
// zero, and what creeps is never fast.
#pragma once

#include <span>

#include "base/room.h"
#include "dynamics/contacts.h"
#include "dynamics/joints.h"

namespace sudar::inline SUDAR_PRECISION {

// Goes on watching bodies that moved for another h: one that got out of the reach of rest begins a new quiet time.
void watch_rest(Bodies&, std::span<const std::uint32_t> awake, Real length_unit, Real h);

// Which bodies faces hold: all their contacts that press do so in three points or more, within their friction, and no
// joint pulls. What is left of their speed is the noise of a solver that has not converged, as in tall towers. By slot.
class HeldByFaces {
 public:
  // Before the contacts and joints of a sub-step: who may be asked about.
  void reset(std::uint32_t slots, std::span<const std::uint32_t> awake) {
    make_room(pressed_, slots), make_room(loose_, slots);
    for (const std::uint32_t i : awake) pressed_[i] = loose_[i] = 0;
  }
  void contact(std::uint32_t a, std::uint32_t b, const ContactImpulse& impulse, bool slipping);
  void joint(std::uint32_t a, std::uint32_t b);
  bool operator[](std::uint32_t i) const { return pressed_[i] != 0 && loose_[i] == 0; }

 private:
  std::vector<std::uint8_t> pressed_, loose_;
};

// After at least half a second of quiet: whether the body would stay within 10⁻⁵ m and 10⁻⁵ rad of where it is for some
// seconds more, even if all it did in its quiet time was to gather speed. What faces hold need only have been slow.
bool rests(const Bodies&, std::uint32_t i, bool held);

// It begins to be watched anew.
inline void disturb(Bodies& b, std::uint32_t i) { b.quiet_time[i] = b.slow_time[i] = 0; }

}
