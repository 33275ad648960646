// A scenario that somebody plays with: the session, what a hand does to it, and the recording of both. Knows nothing of
// threads and pictures. A run and what is saved of it go on with the same bits, given the same deeds before the same
// steps.
#pragma once

#include <sudar/session.h>

#include "history/deeds.h"
#include "main/playback.h"
#include "main/recording.h"

namespace sudar::history {

class Run {
 public:
  Run(const ScenarioEntry&, Settings);      // from the start; throws Error
  Run(std::unique_ptr<Session>, Settings);  // from where that is; `settings`: of a restart

  struct Grabbed {
    Body body;
    Vec3 point;    // in the body's frame
    double depth;  // from the eye along the view, m
    Pos target;
  };
  struct Saved {
    Bytes session;
    Settings settings;
    std::int32_t workers;  // of this machine, and so in no state
    std::optional<Grabbed> grabbed;
    Vec3 twist;
  };
  Saved save() const;
  Run(const ScenarioEntry&, const Saved&);

  void step();
  void perform(const Deed&);  // throws Error, and has changed nothing then
  void become(Run&&);         // goes on as that one; a recording goes on, too, and holds the change

  void start_recording();        // into a file that grows
  std::string stop_recording();  // returns what the file holds, in words; empty: nothing was recorded
  bool recording() const { return recording_ != nullptr; }

  const Session& session() const { return *session_; }
  const World& world() const { return session_->world(); }
  const Settings& settings() const { return settings_; }
  const app::Playback& playback() const { return *playback_; }
  bool grabs() const { return grabbed_.has_value(); }
  struct Spring {
    Pos from, to;
  };
  std::optional<Spring> spring() const;  // of the drag, for drawing

 private:
  void act(const Hold&);
  void act(const Grab&);
  void act(const DragTo&);
  void act(const Twist&);
  void act(const Release&);
  void act(const Shoot&);
  void act(const Insert&);
  void act(const Remove&);
  void act(const Configure&);
  void pull();  // one step's push
  World& own() { return session_->world(); }

  Settings settings_;
  std::unique_ptr<Session> session_;
  std::unique_ptr<app::Playback> playback_;
  std::unique_ptr<app::Recording> recording_;
  std::optional<Grabbed> grabbed_;
  Vec3 twist_{};
};

}
