// Dear ImGui, fed from a queue of events. ImGui 1.86 has no queue of its own: it sees the keys and buttons that are
// down when a picture is made, and on a machine that makes four pictures a second a click with Ctrl, or a word typed
// quickly, is lost. So every event gets a frame of its own. Such frames are cheap: only the last one before a picture
// is drawn.
#pragma once

#include <deque>
#include <optional>

#include "ui/window.h"

namespace sudar::ui {

class Gui {
 public:
  explicit Gui(Window&);
  ~Gui();
  Gui(const Gui&) = delete;

  void take(const std::vector<InputEvent>&);
  bool pending() const { return !queue_.empty() || answering_ > 0; }  // are there frames to make before the picture?
  // The next frame of panels; returns its event, unless the panels want that for themselves.
  std::optional<InputEvent> begin();
  void end();   // of a frame that is not shown
  void draw();  // ends the frame, and draws it over what there is

 private:
  void feed(const InputEvent&);
  bool wanted_by_panels(const InputEvent&) const;

  Window& window_;
  std::deque<InputEvent> queue_;
  int answering_ = 0;  // empty frames to come
  double last_ = 0;    // s
};

}
