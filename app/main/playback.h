// What is drawn step by step: a scenario that runs, or a recording.
#pragma once

#include <sudar/record.h>
#include <sudar/session.h>

#include "main/scene_options.h"
#include "view/png.h"
#include "view/scene.h"

namespace sudar::app {

class Playback {
 public:
  virtual ~Playback() = default;
  virtual const World& world() const = 0;
  virtual void step() = 0;
  virtual bool over() const = 0;              // there is no next step
  virtual double seconds() const = 0;         // simulated time that it usually lasts
  virtual double telling_moment() const = 0;  // when a picture shows what it is about, s
  virtual std::optional<Camera> camera() const = 0;
  virtual std::string title() const = 0;
  virtual std::string parameters() const = 0;

  void advance_to(double time) {
    while (!over() && world().time() < time - 1e-9) step();
  }
};

// The picture of it as it is now.
view::Scene scene_of(const Playback&, const view::Detail& = {});

// A recording where there is a file of that name, else a scenario.
std::unique_ptr<Playback> open_playback(const SceneOptions&, const Catalogue&);

// A scenario whose session the caller keeps.
std::unique_ptr<Playback> play(Session&);

// Where a picture comes from: version, scenario, parameters, time, step, state.
view::PngText provenance(const Playback&);

}
