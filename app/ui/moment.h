// A run after one of its steps, as it is shown: immutable, independent of the run from then on.
#pragma once

#include "history/chart.h"

namespace sudar::ui {

using namespace history;

struct BodyFacts {
  Body body;
  std::string name;
  double mass = 0, energy = 0;
  Pose pose;
  Vec3 velocity, spin;
  bool asleep = false;
};

// What has curves of its own beside the selected body: its joints and contacts.
struct Related {
  std::string title;
  Quantity quantity;
};

// Where in its history a run is.
struct Timeline {
  Place here;
  std::int64_t begin = 0, end = 0;  // frames of this branch
  std::vector<History::Branch> branches;
  std::size_t bytes = 0;
  bool undo = false, redo = false;  // is there anything to?
};

struct Moment {
  const ScenarioEntry* entry = nullptr;
  std::int64_t run = 0;  // a new number is a new world: nothing is drawn between moments of two runs
  std::int64_t steps = 0;
  double time = 0;  // simulated, s
  view::Scene scene;
  Config config;
  std::vector<Params::Entry> params;
  std::vector<KeyHelp> keys;
  std::optional<Camera> camera;
  std::size_t bodies = 0, joints = 0, contacts = 0;
  Energy energy;
  double step_us = 0;
  std::optional<BodyFacts> selected;
  std::vector<Related> related;  // to the selected body
  std::optional<Run::Spring> spring;
  bool recording = false;
  bool abandoned = false;  // by its scenario (session.h)
  Timeline timeline;
  bool ghost = true;  // is one wanted …
  int ghost_of = -1;  // … and of which branch; −1: there is none
  std::shared_ptr<const Chart> chart;
};

// All but `run`, `step_us` and `chart`. `ghost`: another branch's run, drawn translucent; null: none.
Moment moment_of(const History&, const view::Detail&, Body selected, const Run* ghost);

}
