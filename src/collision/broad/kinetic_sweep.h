// Kinetic sweep and prune, thesis (3.27), after Coming & Staadt (2006, "Kinetic sweep and prune for multi-body
// continuous motion"): during an update, whose time runs from 0 to 1, the end points move linearly from the old boxes
// to the new ones, and the lists stay in order all the way. Two neighbours that will stand the other way round at the
// end pass each other exactly once; a queue holds these events and gives them in order of time, each of which makes two
// new pairs of neighbours. O(n + passings · log passings). What all kinds of sweep share is in end_points.h.
//
// The passings are those of the insertion sort, only in the order in which they happen: a factor log more, for which
// one knows when each pair begins and sees the pairs that overlap on the way only (a bullet through a wall). The engine
// asks for the pairs at the end alone, so this kind is here as the thesis names it, and never the fastest.
//
// Whether an event exists is decided by the order at the end, which is exact; rounding can change its time only. So the
// queue never runs in circles, and the lists are in order when it is empty.
#pragma once

#include "collision/broad/end_points.h"

namespace sudar::inline SUDAR_PRECISION {

class KineticSweep final : public EndPointSweep {
 private:
  struct Event {
    double time;
    std::uint32_t axis, left, right;  // left, right: ids of neighbours that will pass each other
  };
  // One axis during an update.
  struct Course {
    std::vector<double> start;         // where an end point was, by id
    std::vector<std::uint32_t> place;  // in the axis, by id
  };

  bool sort(std::array<Axis, 3>& axes) override;
  void expect(const Axis& axis, std::uint32_t k, std::size_t left);

  std::array<Course, 3> courses_;
  std::vector<Event> queue_;  // a heap, the earliest first
};

}
