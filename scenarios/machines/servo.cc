// Bodies that servo controllers drive to their goals, with a limit on the force along each axis. The controller knows
// the fastest approach from which the limit still stops; from rest that is full force half the way and full brake the
// other half, 2 √(m d / F): nothing is faster. One servo works against a thruster that is almost as strong.
#include "thesis.h"

using namespace sudar;

struct Servo : Scenario {
  static constexpr double seconds = 30;
  static constexpr double picture = 3;
  static constexpr const char* about = "controllers with limited force drive boxes to their goals";
  struct Task {
    Pos from, to;
    Vec3 velocity;
  };
  static constexpr Task tasks[] = {{{0, -5, 0}, {0, 0, 0}, {}},
                                   {{-5, -5, 0}, {-5, 0, 0}, {0, -5, 0}},
                                   {{5, -5, 0}, {5, 0, 0}, {0, 5, 0}},
                                   {{10, -5, 0}, {10, 0, 0}, {5, 5, 0}},
                                   {{-10, -5, 0}, {-10, 0, 0}, {}}};
  static constexpr std::size_t count = std::size(tasks);
  Real force = 1, thrust = 0.95;
  Body boxes[count];
  double settled[count] = {};  // when it was last away from its goal, s

  void params(Params& p) override {
    p("force", force, 0, 10, "N, limit along each axis"), p("thrust", thrust, 0, 5, "N, against the last");
  }
  void state(State& s) override { s("boxes", boxes), s("settled", settled); }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    for (std::size_t i = 0; i < count; ++i) {
      boxes[i] = w.add({.shape = box({1, 1, 1}),
                        .at = tasks[i].from,
                        .velocity = tasks[i].velocity,
                        .density = 1,
                        .filter = {.mask = 0},
                        .sleeps = false});
    }
    // The goals, for the eye alone.
    for (const Task& task : tasks) {
      w.add({.shape = sphere(0.3), .at = task.to, .filter = {.mask = 0}, .motion = Motion::fixed, .name = "goal"});
    }
    w.add(Thruster{.body = boxes[count - 1], .force = {0, -thrust, 0}});
  }

  // The force that brings the speed, in one step, to the fastest from which `most` can stop over `way`.
  static Real drive(Real way, Real speed, Real mass, Real most, Real h) {
    const Real half = most / mass * h / 2;
    const Real stoppable = min(sqrt(square(half) + 2 * most / mass * abs(way)) - half, abs(way) / h);
    return clamp(mass * ((way < 0 ? -stoppable : stoppable) - speed) / h, -most, most);
  }
  void control(World& w, const Input&) override {
    const Real h = Real(w.config().dt);
    for (std::size_t i = 0; i < count; ++i) {
      const BodyView b = w[boxes[i]];
      const Vec3 way = tasks[i].to - b.center(), speed = b.velocity();
      Vec3 push;
      for (int k = 0; k < 3; ++k) push[k] = drive(way[k], speed[k], b.mass(), force, h);
      w.push(boxes[i], push, b.center());
    }
  }

  void observe(const World& w, Check&) override {
    for (std::size_t i = 0; i < count; ++i) {
      if (length(w[boxes[i]].center() - tasks[i].to) > 2e-4) settled[i] = w.time();
    }
  }
  void check(const World& w, Check& c) override {
    c.near("the first settles after", settled[0], 2 * sqrt(5.0 / force), 0.05, "s");
    for (std::size_t i = 0; i < count; ++i) {
      const double off = length(w[boxes[i]].center() - tasks[i].to);
      c.below("box " + std::to_string(i + 1) + ": off its goal", off, 0.01, "m");
    }
  }
  std::optional<Camera> camera() const override { return Camera{{8, 0, 44}, {4, -5, 0}}; }
};
SUDAR_SCENARIO(Servo, "Machines/Servo")
