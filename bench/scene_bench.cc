// What the scenes of bench/scenes.h cost, and how well they are done: a line each, and JSON.
//   bench_scenes [NAME…] [--steps N] [--watch N] [--workers N] [--set FIELD=VALUE]… [--json FILE]
// JSON: an array with an object for each scene.
#include <sudar/session.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <fstream>

#include "bench/scene_run.h"

namespace {

using namespace sudar;
using namespace sudar::bench;

class Sudar : public SceneEngine {
 public:
  Sudar(const Scene& scene, const Config& config) : world_(config) {
    for (const Solid& solid : scene.solids) shapes_.push_back(shape(solid));
    world_.add(Gravity{{0, Real(-scene_gravity), 0}});
  }
  const char* name() const override { return "sudar"; }
  void add(const SceneBody& b) override {
    BodyDef def{.shape = shapes_[b.solid],
                .at = b.at,
                .turn = convert<Real>(b.turn),
                .velocity = convert<Real>(b.velocity),
                .density = Real(b.density),
                .motion = b.motion};
    def.material.friction_static = def.material.friction_dynamic = Real(scene_friction);
    if (!b.collides) def.filter.mask = 0;
    bodies_.push_back(world_.add(def));
  }
  void join(const SceneBall& j) override { world_.join(Ball{.a = bodies_[j.a], .b = bodies_[j.b], .at = j.at}); }
  void set_velocity(std::uint32_t body, const Vec3d& v) override {
    world_.set_velocity(bodies_[body], convert<Real>(v), {});
  }
  void step() override { world_.step(); }
  Pose pose(std::uint32_t body) const override { return world_[bodies_[body]].pose(); }

 private:
  World world_;
  std::vector<Shape> shapes_;
  std::vector<Body> bodies_;
};

struct Options {
  std::vector<std::string> scenes, set;
  RunOptions run;
  int workers = 1;
  std::string json;
};

Config config(const Options& o) {
  Config c;
  c.dt = scene_dt, c.substeps = scene_substeps, c.sleep = false, c.workers = o.workers;
  for (const std::string& text : o.set) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw Error("--set", "\"" + text + "\" given, FIELD=VALUE expected");
    set_field(c, text.substr(0, equals), text.substr(equals + 1));
  }
  return c;
}

void bench_scenes(const Options& o) {
  const Config c = config(o);
  std::vector<Scene> scenes;
  for (const std::string& name : o.scenes) scenes.push_back(make_scene(name));
  std::ofstream file;
  if (!o.json.empty()) {  // before the work
    file.open(o.json);
    if (!file) throw Error(o.json, "cannot be written");
  }
  auto all = nlohmann::ordered_json::array();
  std::fputs(table_head().c_str(), stdout);
  for (const Scene& scene : scenes) {
    Sudar engine(scene, c);
    const SceneRun r = run(scene, engine, o.run);
    std::fputs(table_row(r).c_str(), stdout);
    std::fflush(stdout);
    all.push_back(json(r));
  }
  if (o.json.empty()) return;
  file << all.dump(2) << '\n';
  if (!file.flush()) throw Error(o.json, "cannot be written");
}

}

int main(int argc, char** argv) {
  Options o;
  for (const char* name : scene_names()) o.scenes.push_back(name);
  CLI::App app("What the scenes that engines are compared on cost, and how well they are done");
  app.add_option("scenes", o.scenes, "also towerN, pyramidN, pileN for any N, and 16k for 16384")
      ->capture_default_str();
  app.add_option("--steps", o.run.steps, "of each scene; else its own number")->check(CLI::Range(2, 1000000));
  app.add_option("--watch", o.run.watch, "measure the quality every so many steps, for the worst of it")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--workers", o.workers, "threads that share a step")->check(CLI::Range(1, 256));
  app.add_option("--set", o.set, "setting of the engine by its path, as sudar run --config")->allow_extra_args(false);
  app.add_option("--json", o.json, "file for the results");
  CLI11_PARSE(app, argc, argv);
  try {
    bench_scenes(o);
  } catch (const Error& e) {
    std::fprintf(stderr, "%s\n", e.what());
    return 1;
  }
}
