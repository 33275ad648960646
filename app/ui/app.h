// The window: what `sudar` opens where there is a display.
#pragma once

#include <sudar/session.h>

#include <string>

#include "view/renderer.h"

namespace sudar::ui {

struct Options {
  std::string scene;  // empty: the wall, else the first that there is
  int width = 1280, height = 720;
  std::optional<view::Finish> quality;  // of the picture; none: as the machine can
  std::string status;  // a file that always tells the state as JSON, for tests and scripts; empty: none
};

// Until the user quits; returns the exit code. Throws Error when no window can be opened.
int run_window(const Catalogue&, const Options&);

}
