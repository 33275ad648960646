// The panels round the picture, in Dear ImGui: above the menu and the transport, at the left the scenarios and what can
// be set, below the timeline, plots and the line of state; over the picture the scenario's keys, help, what was just done.
#pragma once

#include "ui/file_dialog.h"
#include "ui/menu_bar.h"
#include "ui/notes.h"
#include "ui/plot.h"
#include "ui/timeline.h"

namespace sudar::ui {

class Panels {
 public:
  explicit Panels(Controls& controls) : controls_(controls) {}
  // Draws them into a window of that size; returns what they leave for the picture.
  Area draw(int width, int height, double frames_per_second);

 private:
  void scenarios();
  void parameters();
  void engine();
  void selection();
  void files();
  void state_line(float width, float height, double frames_per_second);

  Controls& controls_;
  MenuBar menu_bar_{controls_};
  Notes notes_{controls_};
  TimelineBar timeline_{controls_};
  Plot plot_{controls_};
  FileDialog file_dialog_{controls_.places};
  char search_[64] = "";
  const ScenarioEntry* listed_ = nullptr;  // the one that the list was last scrolled to
  std::map<std::string, double> edited_;  // parameters, until the run has them
  std::int64_t edited_run_ = 0;
};

}
