// A scene run by an engine: what it costs and how well it is done, in the same words for every engine.
#pragma once

#include <nlohmann/json.hpp>

#include "bench/quality.h"

namespace sudar::bench {

// An engine with one world. It is made for a scene, whose solids it may make ready; bodies are numbered as they are
// added.
class SceneEngine {
 public:
  virtual ~SceneEngine() = default;
  virtual const char* name() const = 0;
  virtual void add(const SceneBody&) = 0;
  virtual void join(const SceneBall&) = 0;
  virtual void set_velocity(std::uint32_t body, const Vec3d&) = 0;
  virtual void step() = 0;
  virtual Pose pose(std::uint32_t body) const = 0;
};

struct SceneRun {
  std::string engine, scene;
  int steps = 0;
  std::size_t bodies = 0, joints = 0;  // at the end
  double ms = 0, wall_ms = 0;          // a step, the first left out: processor time of all threads, and by the clock
  SceneQuality quality;                // at the end
  // m, in all steps that were watched, the last among them.
  double penetration_any = 0, joint_gap_any = 0;
};
struct RunOptions {
  int steps = 0;  // 0: the scene's own; else at least 2
  int watch = 0;  // measure the quality every so many steps, too: outside the time, but caches are cold after it
};
SceneRun run(const Scene&, SceneEngine&, const RunOptions&);

nlohmann::ordered_json json(const SceneRun&);  // what is not finite or means nothing in the scene is null
std::string table_head();
std::string table_row(const SceneRun&);

}
