// What a hand does to a run, as data: performed now, kept, and performed again at the same step when it is made again.
// Each becomes operations of World, so that a recording replays it.
#pragma once

#include <sudar/world.h>

#include <string>
#include <variant>
#include <vector>

namespace sudar::history {

// A half line from the eye, as the mouse points: `direction` and `forward` (where the camera looks) have length 1.
struct Ray {
  Pos from;
  Vec3 direction, forward;
};

enum class Solid { box, sphere };

struct Hold {  // these keys and no others, with the camera looking that way
  std::vector<std::string> keys;
  Vec3 view{0, 0, -1};
};
// A critically damped spring between the body's point under the mouse and the mouse.
struct Grab {
  Body body;
  Ray ray;
};
struct DragTo {
  Ray ray;
};
struct Twist {  // the grabbed body turns like that, rad/s; zero: as it likes
  Vec3 spin;
};
struct Release {};
struct Shoot {  // `scale`: a length that the scene is large, m
  Ray ray;
  double scale;
};
struct Insert {  // on what the ray hits, else where it passes at that distance
  Solid solid;
  Ray ray;
  double scale;
};
struct Remove {
  Body body;
};
struct Configure {
  Config config;
};

using Deed = std::variant<Hold, Grab, DragTo, Twist, Release, Shoot, Insert, Remove, Configure>;

// Does it change what there is, so that it is worth a mark and an undo? Else it goes with another one, or steers.
inline bool is_edit(const Deed& d) {
  return std::holds_alternative<Grab>(d) || std::holds_alternative<Shoot>(d) || std::holds_alternative<Insert>(d) ||
         std::holds_alternative<Remove>(d) || std::holds_alternative<Configure>(d);
}

}
