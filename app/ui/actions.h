// What the program can be told by a key or in a menu. One list: it makes the shortcuts, the menus' texts and the help.
#pragma once

#include <span>
#include <string>

namespace sudar::ui {

enum class Action {
  open,
  save,
  pause,
  step,
  ten_steps,
  step_back,
  ten_steps_back,
  play_backwards,
  newest,
  restart,
  faster,
  slower,
  real_time,
  previous,
  next,
  search,
  frame_selection,
  frame_all,
  follow,
  shoot,
  add_box,
  add_sphere,
  remove,
  undo,
  redo,
  contacts,
  joints,
  forces,
  labels,
  boxes,
  cells,
  colours,
  wireframe,
  axes,
  sleep,
  ghost,
  plots,
  panels,
  help,
  fullscreen,
  screenshot,
  movie,
  record,
  cancel,
  quit,
};

struct Binding {
  Action action;
  int key, mods;         // GLFW's
  const char* shortcut;  // as it is written; empty: another key for the same, not listed
  const char* does;
};

std::span<const Binding> bindings();
const Binding* find_binding(int key, int mods);  // null: the key means nothing
const Binding& binding_of(Action);               // the first, for menus

// GLFW's key as scenarios call it ("up", "space", "a"); empty: not a key for scenarios.
std::string key_name(int key);

}
