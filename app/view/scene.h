// What is drawn: plain data, taken from a world at one moment and from then on independent of it. Physics never draws,
// drawing never touches physics; a window draws a mixture of two scenes.
#pragma once

#include <sudar/world.h>

#include <optional>
#include <string>

#include "view/linear.h"

namespace sudar::view {

// One shape of a body.
struct Instance {
  std::uint32_t shape = 0;  // number in Scene::shapes
  Pose pose{};
  Vec3f colour{0.5f, 0.5f, 0.5f};  // linear light, 0…1
  Body body{};                     // null: not a body
  ShapeId part{};                  // which of its shapes
  bool first = true;               // of them: it stands for the body where that counts once
  bool fixed = false, asleep = false;
  float speed = 0;           // m/s
  std::uint32_t island = 0;  // those of one island have the same number; of a body alone its own
  bool alone = true;         // in its island
  std::string name{};
};

struct ContactMark {
  Pos at;
  Vec3f normal;
  bool slipping = false;
};

// What a joint leaves free: a turn about an axis or a way along it.
struct FreedomMark {
  Vec3f axis{}, zero{};  // unit vectors: the axis, and the direction of a turn's angle 0
  bool turns = false;
  float low = 0, high = 0, value = 0;  // rad or m; limits may be infinite
};

struct JointMark {
  Pos anchor_a{}, anchor_b{};
  Pos center_a{}, center_b{};  // of the bodies; the anchor itself where the joint ends in the world
  float size = 0;              // of the smaller body, m
  Vec3f axis{};                // of a hinge or slider, normal of a plane; zero: none
  std::optional<FreedomMark> freedom{};
};

struct ForceMark {
  enum class Kind { weight, stick, slip, joint } kind;
  Pos at{};
  Vec3f force;  // N
};

struct BoxMark {
  Pos low{}, high{};
};

// A thin rod between a body and a joint that is some way off: without it the ball of a pendulum would seem to fly.
struct Link {
  Pos from{}, to{};
  float radius = 0;
};

struct Scene {
  std::vector<Shape> shapes;        // each once
  std::vector<Instance> instances;  // in the order of World::bodies(), and of their shapes
  std::vector<Instance> ghosts;     // of another run: translucent, and nothing that could be picked
  std::vector<ContactMark> contacts;
  std::vector<JointMark> joints;
  std::vector<Link> links;
  // Only where they are asked for.
  std::vector<ForceMark> forces;
  float metres_per_newton = 0;        // of their arrows
  std::vector<BoxMark> boxes, cells;  // of the broad phase: round bodies, of its inner structure
};

// What costs time to gather and is not always shown.
struct Detail {
  bool forces = false, boxes = false, cells = false, islands = false;
  bool operator==(const Detail&) const = default;
};

// Colours depend only on a body's first shape and its number, so that a body keeps its colour all through a movie. `palette`:
// where in the list of colours the scene begins; any number.
Scene make_scene(const World&, const Detail& = {}, std::uint32_t palette = 0);

// The scene between two, for drawing between two steps: bodies, ghosts and links are where `share` (0: before, 1: after) of the
// way has led them; all else is as in `after`.
Scene mix(const Scene& before, const Scene& after, double share);

// Adds an instance; a shape of equal content is shared. For pictures without a world.
void add_instance(Scene&, const Shape&, Instance);

// Adds what moves in `other` and is somewhere else in `scene`, as ghosts.
void add_ghosts(Scene&, const Scene& other);

}
