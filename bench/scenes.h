// The scenes on which engines are compared, as plain data that any engine can build: Box3D's benchmarks and ours. All
// have y up, gravity, steps, sub-steps and friction as below, restitution 0 and no damping, and no body sleeps.
// Positions and sizes are written in double; an engine rounds them to its own precision.
#pragma once

#include <sudar/definitions.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sudar::bench {

inline constexpr double scene_gravity = 10;   // m/s², downwards
inline constexpr double scene_dt = 1.0 / 60;  // s
inline constexpr int scene_substeps = 4;
inline constexpr double scene_friction = 0.6;  // of every body, static and dynamic

struct Solid {
  enum class Kind { box, ball, hull };
  Kind kind = Kind::box;
  Vec3d half{};       // of a box: half its edges, m
  double radius = 0;  // of a ball, m
  // Of a hull, m: all are vertices. In the body's frame, whose origin is not the centre of mass.
  std::vector<Vec3d> points{};
};
Shape shape(const Solid&);  // the same as a shape of ours

struct SceneBody {
  std::uint32_t solid = 0;  // index in Scene::solids
  Pos at{};                 // of the solid's frame, m
  Quatd turn{};
  Vec3d velocity{};       // m/s
  double density = 1000;  // kg/m³
  Motion motion = Motion::dynamic;
  bool collides = true;
  int arrives = 0;  // is added before this step; bodies are listed in the order of their arrival
};

// A ball joint between two bodies.
struct SceneBall {
  std::uint32_t a = 0, b = 0;
  Pos at{};
};

// A kinematic body whose origin goes round the y axis, in chords of one step each; the body does not turn.
struct SceneCircle {
  std::uint32_t body = 0;
  double radius = 0, rate = 0;  // m; rad/s from x to z
};
// Of a step, counted from 0.
Vec3d velocity(const SceneCircle&, int step);

struct Scene {
  std::string name;
  int steps = 0;        // that its figures are of
  bool stands = false;  // every body should stay where it is: drift and sink mean something
  std::vector<Solid> solids{};
  std::vector<SceneBody> bodies{};
  std::vector<SceneBall> joints{};
  std::optional<SceneCircle> circle{};
};

// Those that make_scene() knows by a name of their own. It also knows towerN, pyramidN and pileN for any N, which may
// end in k for 1024: tower10, pile16k. Throws Error for other names.
std::span<const char* const> scene_names();
Scene make_scene(std::string_view name);

}
