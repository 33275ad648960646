// Room in lists by slot that hold nothing between uses.
#pragma once

#include <vector>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

// At least `count` entries, the new ones as T{}. With an eighth to spare: a list of just so many would be copied whole for
// the next body that comes to a large world.
template <class T>
void make_room(std::vector<T>& list, std::size_t count) {
  if (list.size() < count) list.resize(count + count / 8);
}

}
