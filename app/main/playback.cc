#include "main/playback.h"

#include <sudar/io.h>

#include <filesystem>

#include "main/files.h"
#include "main/report.h"

namespace sudar::app {

using namespace view;

namespace {

class Running : public Playback {
 public:
  explicit Running(Session& session) : session_(session) {}
  const World& world() const override { return session_.world(); }
  void step() override { session_.step(); }
  bool over() const override { return false; }
  double seconds() const override { return session_.seconds(); }
  double telling_moment() const override { return std::min(session_.entry().picture, session_.seconds()); }
  std::optional<Camera> camera() const override { return session_.scenario().camera(); }
  std::string title() const override { return session_.entry().name; }
  std::string parameters() const override { return parameters_text(session_); }

 private:
  Session& session_;
};

// With a session of its own, and keys by script.
class Started : public Running {
 public:
  Started(std::unique_ptr<Session> session, const std::string& keys)
      : Running(*session), session_(std::move(session)), keys_(keys) {}
  void step() override {
    keys_.apply(session_->world().time(), session_->input);
    Running::step();
  }

 private:
  std::unique_ptr<Session> session_;
  KeyScript keys_;
};

class Recorded : public Playback {
 public:
  Recorded(const std::string& file, const Catalogue& catalogue)
      : replay_(load_file(file, [](Bytes bytes) { return Replay(std::move(bytes)); })) {
    for (const ScenarioEntry* entry : catalogue.all()) {
      if (entry->name != replay_.title()) continue;
      camera_ = make_scenario(*entry)->camera();
    }
  }
  const World& world() const override { return replay_.world(); }
  void step() override { replay_.step(false); }
  bool over() const override { return replay_.done(); }
  double seconds() const override {
    const Config& config = world().config();
    return double(replay_.steps()) * config.dt * double(config.time_factor);
  }
  double telling_moment() const override { return seconds(); }
  std::optional<Camera> camera() const override { return camera_; }
  std::string title() const override { return replay_.title(); }
  std::string parameters() const override { return "as recorded"; }

 private:
  Replay replay_;
  std::optional<Camera> camera_;
};

}

std::unique_ptr<Playback> open_playback(const SceneOptions& o, const Catalogue& catalogue) {
  const Settings settings = o.settings();
  std::error_code error;
  const bool path = !io::is_readable(o.scene) && (o.scene.find('/') != std::string::npos ||
                                                  std::filesystem::is_regular_file(o.scene, error));
  if (path) {
    if (!settings.set.empty() || !settings.config.empty() || !o.keys.empty()) {
      throw Error(o.scene, "a recording has its parameters, settings and keys already");
    }
    return std::make_unique<Recorded>(o.scene, catalogue);
  }
  return std::make_unique<Started>(std::make_unique<Session>(catalogue.find(o.scene), settings), o.keys);
}

std::unique_ptr<Playback> play(Session& session) { return std::make_unique<Running>(session); }

Scene scene_of(const Playback& p, const Detail& detail) {
  // Every scenario has colours of its own: begin where its name says (FNV-1a, Fowler, Noll and Vo).
  std::uint32_t hash = 2166136261u;
  for (const char c : p.title()) hash = (hash ^ std::uint8_t(c)) * 16777619u;
  return make_scene(p.world(), detail, hash >> 9);
}

PngText provenance(const Playback& p) {
  const World& w = p.world();
  char time[32];
  std::snprintf(time, sizeof time, "%.6g s", w.time());
  return {{"Software", std::string("sudar ") + SUDAR_VERSION + (sizeof(Real) == 4 ? " float" : " double")},
          {"scenario", p.title()},
          {"parameters", p.parameters()},
          {"time", time},
          {"step", std::to_string(w.steps())},
          {"state", hex(w.hash())}};
}

}
