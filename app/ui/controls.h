// What the window's user is about to do and see: the state that keys, mouse and panels share, and what actions mean.
// Physics is told through the Simulation only.
#pragma once

#include "ui/actions.h"
#include "ui/camera_control.h"
#include "ui/places.h"
#include "ui/simulation.h"
#include "view/renderer.h"

namespace sudar::ui {

// Where the picture stands in the window's framebuffer, pixels from the top left.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;
};

class Controls {
 public:
  Controls(const Catalogue& catalogue, Simulation& simulation) : catalogue_(catalogue), simulation_(simulation) {}

  void perform(Action);
  void start(const ScenarioEntry&);
  void restart_with(const std::map<std::string, double>& parameters);
  void set_config(const Config& c) {
    simulation_.perform(Configure{c});
  }
  void set_speed(double s) { simulation_.set_speed(s); }
  void select(Body b) { selected = b, simulation_.select(b); }

  // Once a picture: what the simulation shows now. A new scenario brings its camera, following moves it.
  void look(View, double aspect);
  const View& view() const { return view_; }
  const Moment* moment() const { return view_.after.get(); }  // null: nothing has started yet
  // The keys held, of which a scenario that runs sees those it knows; does this one belong to it?
  bool belongs_to_scenario(int key) const;
  void key(int key, bool down);

  const Catalogue& catalogue() const { return catalogue_; }
  Simulation& simulation() { return simulation_; }

  CameraControl camera;
  view::Style style{.sleep = true};
  view::Scene scene;        // as drawn
  std::int64_t scenes = 0;  // a new number is another scene
  view::Focus focus;        // of the scene when it started
  Area area;                // of the picture
  Ray pointer{};            // where the mouse points
  Body selected{};
  bool labels = false, follow = false, panels = true, plots = true, help = false;
  Places places;         // of widgets
  bool typing = false;   // into a field of a panel
  bool filming = false;  // told by whoever does it
  // Taken up by whoever can, who then takes them down.
  bool wants_open = false, wants_save = false;
  bool wants_search = false, wants_fullscreen = false, wants_screenshot = false, wants_movie = false,
       wants_quit = false;

 private:
  void neighbour(int way);
  bool* switched_by(Action);  // what the action turns on and off; null: nothing
  void toggle_recording();
  void hold();
  std::optional<Pos> place_of(Body) const;

  const Catalogue& catalogue_;
  Simulation& simulation_;
  View view_;
  std::int64_t seen_run_ = 0;
  const ScenarioEntry* seen_entry_ = nullptr;
  view::Detail shown_;
  std::shared_ptr<const Moment> mixed_;  // what `scene` was made of …
  double share_ = 0;                     // … and this much of the way to it
  double aspect_ = 1;
  std::vector<std::string> held_;
};

}
