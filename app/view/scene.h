// What is drawn: plain data, taken from a world at one moment and from then on independent of it. Physics never draws,
// drawing never touches physics; a window draws a mixture of two scenes.
#pragma once

#include <sudar/world.h>

#include "view/linear.h"

namespace sudar::view {

struct Instance {
  std::uint32_t shape = 0;  // number in Scene::shapes
  Pose pose{};
  Vec3f colour{0.5f, 0.5f, 0.5f};  // linear light, 0…1
  Body body{};                     // null: not a body
  bool fixed = false, asleep = false;
};

struct ContactMark {
  Pos at;
  Vec3f normal;
  bool slipping = false;
};

struct JointMark {
  Pos anchor_a{}, anchor_b{};
  Pos center_a{}, center_b{};  // of the bodies; the anchor itself where the joint ends in the world
};

// A thin rod between a body and a joint that is some way off: without it the ball of a pendulum would seem to fly.
struct Link {
  Pos from{}, to{};
  float radius = 0;
};

struct Scene {
  std::vector<Shape> shapes;        // each once
  std::vector<Instance> instances;  // in the order of World::bodies()
  std::vector<ContactMark> contacts;
  std::vector<JointMark> joints;
  std::vector<Link> links;
};

// Colours depend only on a body's shape and number, so that a body keeps its colour all through a movie. `palette`:
// where in the list of colours the scene begins; any number.
Scene make_scene(const World&, std::uint32_t palette = 0);

// The scene between two, for drawing between two steps: bodies and links are where `share` (0: before, 1: after) of the
// way has led them; all else is as in `after`.
Scene mix(const Scene& before, const Scene& after, double share);

// Adds an instance; a shape of equal content is shared. For pictures without a world.
void add_instance(Scene&, const Shape&, Instance);

}
