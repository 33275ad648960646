// The panels round the picture, in Dear ImGui: above the menu and the transport, at the left the scenarios and what can
// be set, below the line of state; over the picture the scenario's keys, help, what was just done.
#pragma once

#include "ui/controls.h"
#include "ui/hand.h"

namespace sudar::ui {

class Panels {
 public:
  explicit Panels(Controls& controls) : controls_(controls) {}
  // Draws them into a window of that size; returns what they leave for the picture.
  Area draw(int width, int height, double frames_per_second);

 private:
  void menu();
  void colours(view::Style&);
  void legend(float right, float top);
  void transport();
  void scenarios();
  void parameters();
  void engine();
  void selection();
  void state_line(float width, float height, double frames_per_second);
  void over_picture(const Area&);
  void help(const Area&);
  bool open_menu(const char* name);
  void item(Action, const bool* on = nullptr);

  Controls& controls_;
  char search_[64] = "";
  std::map<std::string, double> edited_;  // parameters, until the run has them
  std::int64_t edited_run_ = 0;
  std::int64_t seen_message_ = 0;
  Clock::time_point message_since_{};
};

}
