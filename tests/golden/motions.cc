// The motion hashes that tools/golden.py compares: of every scenario, of some with other settings, and of worlds made
// for what no scenario has. Prints {"precision": …, "motions": {name: {step: hash}}}, a motion a line.
#include "scenarios/catalogue.h"

#include <cstdio>

using namespace sudar;

namespace {

// Prints a motion a line.
class Page {
 public:
  Page() { std::printf("{\"precision\": \"%s\",\n  \"motions\": {", sizeof(Real) == 4 ? "float" : "double"); }
  ~Page() { std::printf("}}\n"); }
  Page(const Page&) = delete;

  void motion(const std::string& name, const ScenarioEntry& entry, const Settings& settings) {
    Session session(entry, settings);
    motion(name, session, session.world(), [&] { return session.done(); });
  }
  void motion(const std::string& name, World world, double seconds) {
    motion(name, world, world, [&] { return world.time() >= seconds - 1e-9; });
  }

 private:
  // Hashes after the first step, the hundredth and the last one: a difference was there from the start, or grew, or
  // needed an event.
  template <class Runner, class Done>
  void motion(const std::string& name, Runner& runner, const World& world, Done done) {
    std::printf("%s\n    \"%s\": {", motions_++ == 0 ? "" : ",", name.c_str());
    while (!done()) {
      runner.step();
      const auto step = static_cast<long long>(world.steps());
      if (step != 1 && step != 100 && !done()) continue;
      std::printf("%s\"%lld\": \"%016llx\"", step == 1 ? "" : ", ", step,
                  static_cast<unsigned long long>(world.motion_hash()));
    }
    std::printf("}");
  }

  int motions_ = 0;
};

// Settings that change how the solver works, each where it matters.
struct Variation {
  const char *scenario, *what;
  Settings settings;
};
const Variation variations[] = {
    {"vehicle", "driver", {.set = {{"driver", 1}}}},
    {"chain_ball", "joints_by_passes", {.config = {{"impulse_2007.exact_joints", "false"}}}},
    {"chain_ball", "correction_in_velocity", {.config = {{"impulse_2007.joint_correction_in_velocity", "true"}}}},
    {"towers", "shock_propagation", {.config = {{"impulse_2007.shock_propagation", "true"}}}},
    {"oranges", "one_point_contact", {.config = {{"impulse_2007.one_point_contact", "true"}}}},
    {"seesaw", "friction_per_increment", {.config = {{"impulse_2007.friction_per_increment", "true"}}}},
    {"dzhanibekov", "rk4", {.config = {{"integrator", "rk4"}}}},
    {"card_house", "awake", {.config = {{"sleep", "false"}}}},
    {"wall", "four_substeps", {.config = {{"substeps", "4"}}, .seconds = 4}},
    {"wall", "soft_step", {.config = {{"solver", "soft_step"}}, .seconds = 10}},
    {"towers", "soft_step", {.config = {{"solver", "soft_step"}}, .seconds = 10}},
    {"card_house", "soft_step", {.config = {{"solver", "soft_step"}}, .seconds = 10}},
    {"vehicle", "soft_step", {.config = {{"solver", "soft_step"}}, .seconds = 4}},
};

constexpr sudar::Motion fixed = sudar::Motion::fixed, kinematic = sudar::Motion::kinematic;

Vec3 vec(double x, double y, double z) { return {Real(x), Real(y), Real(z)}; }

World with_floor(const Material& material, Solver solver = Config{}.solver) {
  World w({.solver = solver});
  w.add(Gravity{});
  w.add({.shape = half_space(), .material = material, .motion = fixed});
  return w;
}

// A heap of every kind of shape.
World shapes(Solver solver = Config{}.solver) {
  World w = with_floor({.restitution = Real(0.3), .rolling = Real(0.01), .spinning = Real(0.005)}, solver);
  const Shape all[] = {sphere(0.25),
                       capsule(0.2, 0.4),
                       cylinder(0.25, 0.5),
                       cone(0.3, 0.6),
                       ellipsoid(vec(0.3, 0.2, 0.25)),
                       box(vec(0.4, 0.3, 0.5)),
                       prism(5, 0.3, 0.4),
                       pyramid(4, 0.3, 0.5),
                       uv_sphere(0.25, 12, 6),
                       icosahedron(0.25),
                       truncated_icosahedron(0.1),
                       wedge(vec(0.5, 0.4, 0.3))};
  for (std::size_t i = 0; i < std::size(all); ++i) {
    const double n = double(i), height = 1 + 0.7 * n;
    w.add({.shape = all[i], .at = {0.03 * n - 0.1, height, 0.05}, .turn = rotation(vec(0.3 * n, 0, 0.4 * n))});
    w.add({.shape = all[i], .at = {0.6, height, 0.02 * n - 0.1}, .turn = rotation(vec(0, 0.3 * n, 0.2 * n))});
  }
  return w;
}

// Balls roll in a bowl and out of a pipe.
World hollows() {
  World w;
  w.add(Gravity{});
  w.add({.shape = hollow_sphere(2), .at = {0, 2, 0}, .motion = fixed});
  w.add({.shape = hollow_cylinder(1, 8), .at = {6, 2, 0}, .turn = rotation(vec(0, 0, 1.5)), .motion = fixed});
  for (int i = 0; i < 6; ++i) {
    const Material material{.restitution = Real(0.1 * i), .rolling = Real(0.002 * i)};
    w.add({.shape = sphere(0.2 + 0.02 * i), .at = {0.5 * i - 1.2, 2, 0.1 * i}, .material = material});
    w.add({.shape = sphere(0.3), .at = {3.5 + 0.9 * i, 2, 0.08 * i}, .spin = vec(2, 0, i), .material = material});
  }
  return w;
}

// Beads and rods poured into a box: many contacts, of smooth bodies and edges.
World grains(Solver solver = Config{}.solver) {
  World w = with_floor({.friction_static = Real(0.4), .friction_dynamic = Real(0.3)}, solver);
  for (const double side : {-1.0, 1.0}) {
    w.add({.shape = box(vec(0.2, 2, 2.4)), .at = {1.1 * side, 1, 0}, .motion = fixed});
    w.add({.shape = box(vec(2.4, 2, 0.2)), .at = {0, 1, 1.1 * side}, .motion = fixed});
  }
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 4; ++x) {
      for (int z = 0; z < 4; ++z) {
        const int kind = (x + 2 * y + 3 * z) % 4;
        const Shape shape = kind == 0 ? capsule(0.1, 0.2) : kind == 1 ? box(vec(0.3, 0.2, 0.2)) : sphere(0.15);
        const Pos at{0.45 * (x - 1.5) + 0.01 * y, 0.3 + 0.45 * y, 0.45 * (z - 1.5) + 0.007 * x};
        w.add({.shape = shape, .at = at, .turn = rotation(vec(0.3 * x, 0.2 * y, 0.1 * z)), .density = 2500});
      }
    }
  }
  return w;
}

// What moves by itself: a belt, a rising table, a turning paddle; and a material of two given bodies.
World driven(Solver solver = Config{}.solver) {
  World w = with_floor({}, solver);
  const Body belt =
      w.add({.shape = box(vec(6, 0.4, 2)), .at = {0, 1, 0}, .surface_velocity = vec(1.5, 0, 0), .motion = fixed});
  w.add({.shape = box(vec(2, 0.2, 2)), .at = {4.2, 0.5, 0}, .velocity = vec(0, 0.3, 0), .motion = kinematic});
  w.add({.shape = box(vec(3, 0.6, 0.2)), .at = {-2, 2, 0}, .spin = vec(0, 1.2, 0), .motion = kinematic});
  for (int i = 0; i < 5; ++i) {
    const Pos at{-2.5 + i, 1.6, 0.4 - 0.2 * i};
    const Shape shape = i % 2 == 0 ? box(vec(0.5, 0.5, 0.5)) : cylinder(0.3, 0.4);
    const Body load = w.add({.shape = shape, .at = at, .density = 500});
    if (i == 2) w.set_pair_material(belt, load, Material{.friction_static = Real(0.1), .friction_dynamic = Real(0.1)});
  }
  return w;
}

// Every kind of joint and drive, in mid-air and above the floor.
World joints() {
  World w = with_floor({});
  double z = 0;  // each machine in a plane of its own
  const auto block = [&](double x, double y) {
    return w.add({.shape = box(vec(0.4, 0.4, 0.4)), .at = {x, y, z}, .density = 400, .sleeps = false});
  };
  const auto machine = [&](auto make) {
    z += 2;
    const Body a = block(0, 3), b = block(0.6, 3);
    w.join(make(a, b));
  };
  machine([&](Body a, Body b) {
    w.join(Ball{.b = a, .at = {0, 3.5, z}});
    return Bar{.a = a, .b = b, .at_a = {0.2, 3, z}, .at_b = {0.4, 3, z}};
  });
  machine([&](Body a, Body b) {
    w.join(Rope{.b = a, .at_a = {0, 4, z}, .at_b = {0, 3.2, z}});
    return Hinge{
        .a = a, .b = b, .at = {0.3, 3, z}, .limit = {Real(-0.5), Real(0.7)}, .drive = {DriveMode::speed, 2, 50}};
  });
  machine([&](Body a, Body b) {
    w.join(Slider{.b = a, .at = {0, 3, z}, .limit = {-1, 1}, .drive = {DriveMode::speed, 1, 4000}});
    return Fixed{.a = a, .b = b, .at = {0.3, 3, z}};
  });
  machine([&](Body a, Body b) {
    w.join(Plane{.b = a, .at = {0, 2.8, z}, .normal = vec(0.28, 0.96, 0)});
    return Muscle{
        .a = a,
        .b = b,
        .at_a = {0, 3, z},
        .at_b = {0.6, 3, z},
        .drive = {.mode = DriveMode::spring, .target = Real(0.8), .force = 500, .stiffness = 400, .damping = 5}};
  });
  machine([&](Body a, Body b) {
    w.join(Hinge{
        .b = a, .at = {0, 3.5, z}, .drive = {.mode = DriveMode::servo, .target = 1, .force = 300, .max_speed = 3}});
    return Pulley{.a = a,
                  .b = b,
                  .at_a = {0, 3.2, z},
                  .over_a = {0, 5, z},
                  .over_b = {0.6, 5, z},
                  .at_b = {0.6, 3.2, z},
                  .ratio = 2};
  });
  machine([&](Body a, Body b) {
    w.join(Hinge{.b = b, .at = {0.6, 3, z}});
    return Reel{.a = a, .b = b, .at_a = {0, 2.8, z}, .at = {0.6, 3, z}};
  });
  return w;
}

// Free bodies in a medium that attract each other, two of them with an engine.
World forces() {
  World w;
  w.add(NBody{.gravitational_constant = Real(1e-3), .softening = Real(0.1)});
  w.add(Drag{.linear = Real(0.02), .quadratic = Real(0.01), .angular = Real(0.1), .angular_quadratic = Real(0.01)});
  for (int i = 0; i < 8; ++i) {
    const Pos at{3.0 * (i % 2), 2.0 * (i / 2 % 2), 2.5 * (i / 4)};
    const Body body = w.add({.shape = box(vec(0.5, 0.3, 0.7)),
                             .at = at,
                             .velocity = vec(0.2 * i - 0.7, 0, 0.1),
                             .spin = vec(1, 0.3 * i, 2)});
    if (i % 4 == 0) w.add(Thruster{.body = body, .force = vec(60, 0, 20), .at = vec(0, 0.05, 0.1)});
  }
  return w;
}

}

int main() {
  Page page;
  for (const ScenarioEntry* entry : scenarios().all()) page.motion(entry->name, *entry, {});
  for (const Variation& v : variations) {
    page.motion(std::string(v.scenario) + " " + v.what, scenarios().find(v.scenario), v.settings);
  }
  page.motion("world shapes", shapes(), 5);
  page.motion("world hollows", hollows(), 5);
  page.motion("world grains", grains(), 3);
  page.motion("world driven", driven(), 6);
  page.motion("world joints", joints(), 4);
  page.motion("world forces", forces(), 10);
  page.motion("world shapes soft_step", shapes(Solver::soft_step), 5);
  page.motion("world grains soft_step", grains(Solver::soft_step), 3);
  page.motion("world driven soft_step", driven(Solver::soft_step), 6);
}
