#include "bench/scene_run.h"

#include <cstdio>
#include <ctime>

namespace sudar::bench {

namespace {

double seconds(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

std::string cell(std::optional<double> value, int digits) {
  char text[32];
  if (value)
    std::snprintf(text, sizeof text, " %9.*f", digits, *value);
  else
    std::snprintf(text, sizeof text, " %9s", "-");
  return text;
}

std::optional<double> scaled(std::optional<double> value, double by) {
  return value ? std::optional(*value * by) : std::nullopt;
}

// What a table and JSON say of a run's quality, in their units; none where it means nothing.
struct Figures {
  explicit Figures(const SceneRun& r) {
    const SceneQuality& q = r.quality;
    if (!q.finite) return;
    penetration_max_mm = 1e3 * q.penetration_max, penetration_mean_mm = 1e3 * q.penetration_mean;
    if (r.joints > 0) joint_gap_max_mm = 1e3 * q.joint_gap_max, joint_gap_mean_mm = 1e3 * q.joint_gap_mean;
    drift = q.drift, sink = q.sink;
  }
  std::optional<double> penetration_max_mm, penetration_mean_mm, joint_gap_max_mm, joint_gap_mean_mm, drift, sink;
};

}

SceneRun run(const Scene& scene, SceneEngine& engine, int steps) {
  std::uint32_t bodies = 0;
  const auto add_arrivals = [&](int step) {
    for (; bodies < scene.bodies.size() && scene.bodies[bodies].arrives <= step; ++bodies)
      engine.add(scene.bodies[bodies]);
  };
  add_arrivals(0);
  for (const SceneBall& joint : scene.joints) engine.join(joint);
  double processor = 0, wall = 0;
  for (int step = 0; step < steps; ++step) {
    if (step == 1) processor = -seconds(CLOCK_PROCESS_CPUTIME_ID), wall = -seconds(CLOCK_MONOTONIC);
    add_arrivals(step);
    if (scene.circle) engine.set_velocity(scene.circle->body, velocity(*scene.circle, step));
    engine.step();
  }
  processor += seconds(CLOCK_PROCESS_CPUTIME_ID), wall += seconds(CLOCK_MONOTONIC);

  std::vector<Pose> poses;
  for (std::uint32_t i = 0; i < bodies; ++i) poses.push_back(engine.pose(i));
  return {.engine = engine.name(),
          .scene = scene.name,
          .steps = steps,
          .bodies = bodies,
          .joints = scene.joints.size(),
          .ms = 1e3 * processor / (steps - 1),
          .wall_ms = 1e3 * wall / (steps - 1),
          .quality = measure(scene, poses)};
}

nlohmann::ordered_json json(const SceneRun& r) {
  const Figures f(r);
  nlohmann::ordered_json j = {{"engine", r.engine},           {"scene", r.scene},   {"steps", r.steps},
                              {"bodies", r.bodies},           {"joints", r.joints}, {"ms_per_step", r.ms},
                              {"wall_ms_per_step", r.wall_ms}};
  const auto put = [&](const char* name, std::optional<double> value) {
    j[name] = value ? nlohmann::ordered_json(*value) : nullptr;
  };
  put("max_penetration_end_mm", f.penetration_max_mm), put("mean_penetration_mm", f.penetration_mean_mm);
  j["overlapping_pairs"] = r.quality.overlaps;
  put("drift_m", f.drift), put("sink_m", f.sink);
  put("joint_gap_mean_mm", f.joint_gap_mean_mm), put("joint_gap_max_mm", f.joint_gap_max_mm);
  j["finite"] = r.quality.finite;
  return j;
}

std::string table_head() {
  return "scene           engine   steps  bodies   ms/step   wall ms   overlap max      mean mm     pairs  drift mm   "
         "sink mm"
         "   gap max   mean mm\n";
}

std::string table_row(const SceneRun& r) {
  const Figures f(r);
  char text[128];
  std::snprintf(text, sizeof text, "%-15s %-8s %5d %7zu", r.scene.c_str(), r.engine.c_str(), r.steps, r.bodies);
  return text + cell(r.ms, 4) + cell(r.wall_ms, 4) + "    " + cell(f.penetration_max_mm, 3) + "   " +
         cell(f.penetration_mean_mm, 3) + cell(double(r.quality.overlaps), 0) + cell(scaled(f.drift, 1e3), 2) +
         cell(scaled(f.sink, 1e3), 2) + cell(f.joint_gap_max_mm, 3) + cell(f.joint_gap_mean_mm, 3) +
         (r.quality.finite ? "\n" : "  not finite\n");
}

}
