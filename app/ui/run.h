// A scenario that somebody plays with: the session, what a hand does to it, and the recording of both. Knows nothing of
// threads and pictures. Whatever a hand does becomes operations of World, so that a recording replays it.
#pragma once

#include <sudar/session.h>

#include "main/playback.h"
#include "main/recording.h"

namespace sudar::ui {

// A half line from the eye, as the mouse points: `direction` and `forward` (where the camera looks) have length 1.
struct Ray {
  Pos from;
  Vec3 direction, forward;
};

enum class Solid { box, sphere };

class Run {
 public:
  Run(const ScenarioEntry&, Settings);  // throws Error

  void step();
  // From the start, with these parameters and the settings made so far. A recording goes on: it holds that, too.
  void restart(const std::map<std::string, double>& parameters);
  void set_config(const Config&);  // of the world as it is, at once, and after a restart
  void hold(std::vector<std::string> keys, const Vec3& view);

  // A critically damped spring between the body's point under the mouse and the mouse.
  void grab(Body, const Ray&);
  void drag_to(const Ray&);
  void twist(const Vec3& spin) { twist_ = spin; }  // the grabbed body turns like that, rad/s; zero: as it likes
  void release() { grabbed_.reset(); }

  Body shoot(const Ray&, double scale);          // `scale`: a length that the scene is large, m
  Body insert(Solid, const Ray&, double scale);  // on what the ray hits, else where it passes at that distance
  void remove(Body);

  void start_recording();        // into a file that grows
  std::string stop_recording();  // returns what the file holds, in words; empty: nothing was recorded
  bool recording() const { return recording_ != nullptr; }

  const Session& session() const { return *session_; }
  const Settings& settings() const { return settings_; }
  const app::Playback& playback() const { return *playback_; }
  struct Spring {
    Pos from, to;
  };
  std::optional<Spring> spring() const;  // of the drag, for drawing

 private:
  struct Grab {
    Body body;
    Vec3 point;    // in the body's frame
    double depth;  // from the eye along the view, m
    Pos target;
  };
  void take(std::unique_ptr<Session>);
  void pull();  // one step's push
  World& world() { return session_->world(); }

  Settings settings_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Playback> playback_;
  std::unique_ptr<app::Recording> recording_;
  std::optional<Grab> grabbed_;
  Vec3 twist_{};
};

}
