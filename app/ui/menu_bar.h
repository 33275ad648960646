// Above everything: the menus, whose items are the actions, and the transport.
#pragma once

#include "ui/controls.h"

namespace sudar::ui {

class MenuBar {
 public:
  explicit MenuBar(Controls& controls) : controls_(controls) {}
  int draw();  // returns its height, pixels; 0: there was no room

 private:
  void menus();
  void colours(view::Style&);
  void transport();
  bool open_menu(const char* name);
  void item(Action, const bool* on = nullptr);

  Controls& controls_;
};

}
