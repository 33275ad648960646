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
    penetration_p99_mm = 1e3 * q.penetration_p99, penetration_any_mm = 1e3 * r.penetration_any;
    if (r.joints > 0) {
      joint_gap_max_mm = 1e3 * q.joint_gap_max, joint_gap_mean_mm = 1e3 * q.joint_gap_mean;
      joint_gap_any_mm = 1e3 * r.joint_gap_any;
    }
    drift = q.drift, sink = q.sink;
  }
  std::optional<double> penetration_max_mm, penetration_mean_mm, penetration_p99_mm, penetration_any_mm;
  std::optional<double> joint_gap_max_mm, joint_gap_mean_mm, joint_gap_any_mm, drift, sink;
};

}

SceneRun run(const Scene& scene, SceneEngine& engine, const RunOptions& options) {
  SceneRun r{.engine = engine.name(),
             .scene = scene.name,
             .steps = options.steps > 0 ? options.steps : scene.steps,
             .joints = scene.joints.size(),
             .quality = {}};
  std::uint32_t bodies = 0;
  const auto add_arrivals = [&](int step) {
    for (; bodies < scene.bodies.size() && scene.bodies[bodies].arrives <= step; ++bodies)
      engine.add(scene.bodies[bodies]);
  };
  add_arrivals(0);
  for (const SceneBall& joint : scene.joints) engine.join(joint);
  const auto look = [&] {
    std::vector<Pose> poses;
    for (std::uint32_t i = 0; i < bodies; ++i) poses.push_back(engine.pose(i));
    r.quality = measure(scene, poses);
    r.penetration_any = max(r.penetration_any, r.quality.penetration_max);
    r.joint_gap_any = max(r.joint_gap_any, r.quality.joint_gap_max);
  };
  const auto advance = [&](int first, int end) {
    for (int step = first; step < end; ++step) {
      add_arrivals(step);
      if (scene.circle) engine.set_velocity(scene.circle->body, velocity(*scene.circle, step));
      engine.step();
    }
  };
  advance(0, 1);
  const int block = options.watch > 0 ? options.watch : r.steps;
  for (int first = 1; first < r.steps; first += block) {
    const double processor = seconds(CLOCK_PROCESS_CPUTIME_ID), wall = seconds(CLOCK_MONOTONIC);
    advance(first, min(first + block, r.steps));
    r.ms += 1e3 * (seconds(CLOCK_PROCESS_CPUTIME_ID) - processor) / (r.steps - 1);
    r.wall_ms += 1e3 * (seconds(CLOCK_MONOTONIC) - wall) / (r.steps - 1);
    look();
  }
  r.bodies = bodies;
  return r;
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
  put("p99_penetration_mm", f.penetration_p99_mm), put("max_penetration_any_mm", f.penetration_any_mm);
  j["overlapping_pairs"] = r.quality.overlaps, j["below_ground"] = r.quality.below_ground;
  put("drift_m", f.drift), put("sink_m", f.sink);
  put("joint_gap_mean_mm", f.joint_gap_mean_mm), put("joint_gap_max_mm", f.joint_gap_max_mm);
  put("joint_gap_any_mm", f.joint_gap_any_mm);
  j["finite"] = r.quality.finite;
  return j;
}

std::string table_head() {
  return "scene           engine   steps  bodies   ms/step   wall ms   overlap max      mean mm     pairs"
         "  drift mm   sink mm   gap max   mean mm\n";
}

std::string table_row(const SceneRun& r) {
  const Figures f(r);
  char text[128];
  std::snprintf(text, sizeof text, "%-15s %-8s %5d %7zu", r.scene.c_str(), r.engine.c_str(), r.steps, r.bodies);
  return text + cell(r.ms, 4) + cell(r.wall_ms, 4) + "    " + cell(f.penetration_max_mm, 3) + "   " +
         cell(f.penetration_mean_mm, 3) + cell(double(r.quality.overlaps), 0) + cell(scaled(f.drift, 1e3), 2) +
         cell(scaled(f.sink, 1e3), 2) + cell(f.joint_gap_max_mm, 3) + cell(f.joint_gap_mean_mm, 3) +
         (r.quality.finite ? "" : "  not finite") +
         (r.quality.below_ground > 0 ? "  " + std::to_string(r.quality.below_ground) + " below ground\n" : "\n");
}

}
