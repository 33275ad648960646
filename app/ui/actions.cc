#include "ui/actions.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

namespace sudar::ui {

namespace {

constexpr int plain = 0, shift = GLFW_MOD_SHIFT, ctrl = GLFW_MOD_CONTROL;

constexpr Binding all[] = {
    {Action::open, GLFW_KEY_O, ctrl, "Ctrl+O", "Open a saved run"},
    {Action::save, GLFW_KEY_S, ctrl, "Ctrl+S", "Save this run"},
    {Action::pause, GLFW_KEY_SPACE, plain, "Space", "Pause, run"},
    {Action::pause, GLFW_KEY_P, plain, "", ""},
    {Action::step, GLFW_KEY_PERIOD, plain, ".", "Step"},
    {Action::step, GLFW_KEY_RIGHT, plain, "", ""},
    {Action::ten_steps, GLFW_KEY_PERIOD, shift, "Shift+.", "Ten steps"},
    {Action::ten_steps, GLFW_KEY_RIGHT, shift, "", ""},
    {Action::step_back, GLFW_KEY_COMMA, plain, ",", "Step back"},
    {Action::step_back, GLFW_KEY_LEFT, plain, "", ""},
    {Action::ten_steps_back, GLFW_KEY_COMMA, shift, "Shift+,", "Ten steps back"},
    {Action::ten_steps_back, GLFW_KEY_LEFT, shift, "", ""},
    {Action::play_backwards, GLFW_KEY_SPACE, shift, "Shift+Space", "Play backwards, pause"},
    {Action::newest, GLFW_KEY_END, plain, "End", "To the newest step"},
    {Action::restart, GLFW_KEY_R, plain, "R", "Restart"},
    {Action::restart, GLFW_KEY_BACKSPACE, plain, "", ""},
    {Action::faster, GLFW_KEY_EQUAL, plain, "+", "Faster"},
    {Action::faster, GLFW_KEY_EQUAL, shift, "", ""},
    {Action::faster, GLFW_KEY_KP_ADD, plain, "", ""},
    {Action::slower, GLFW_KEY_MINUS, plain, "-", "Slower"},
    {Action::slower, GLFW_KEY_KP_SUBTRACT, plain, "", ""},
    {Action::real_time, GLFW_KEY_1, plain, "1", "Real time"},
    {Action::previous, GLFW_KEY_LEFT_BRACKET, plain, "[", "Previous scenario"},
    {Action::next, GLFW_KEY_RIGHT_BRACKET, plain, "]", "Next scenario"},
    {Action::search, GLFW_KEY_K, ctrl, "Ctrl+K", "Search scenarios"},
    {Action::frame_selection, GLFW_KEY_F, plain, "F", "Show the selected body, or all"},
    {Action::frame_all, GLFW_KEY_HOME, plain, "Home", "Show all"},
    {Action::follow, GLFW_KEY_F, ctrl, "Ctrl+F", "Follow the selected body"},
    {Action::shoot, GLFW_KEY_B, plain, "B", "Shoot a ball"},
    {Action::add_box, GLFW_KEY_INSERT, plain, "Insert", "Add a box under the mouse"},
    {Action::add_sphere, GLFW_KEY_INSERT, shift, "Shift+Insert", "Add a sphere under the mouse"},
    {Action::remove, GLFW_KEY_DELETE, plain, "Delete", "Remove the selected body"},
    {Action::undo, GLFW_KEY_Z, ctrl, "Ctrl+Z", "Undo: back to before the last edit"},
    {Action::redo, GLFW_KEY_Z, ctrl | shift, "Ctrl+Shift+Z", "Redo: to behind the next edit"},
    {Action::redo, GLFW_KEY_Y, ctrl, "", ""},
    {Action::contacts, GLFW_KEY_C, plain, "C", "Contacts"},
    {Action::joints, GLFW_KEY_J, plain, "J", "Joints"},
    {Action::forces, GLFW_KEY_O, plain, "O", "Forces"},
    {Action::labels, GLFW_KEY_N, plain, "N", "Names"},
    {Action::boxes, GLFW_KEY_G, plain, "G", "Boxes of the broad phase"},
    {Action::cells, GLFW_KEY_G, shift, "Shift+G", "Cells or tree of the broad phase"},
    {Action::colours, GLFW_KEY_K, plain, "K", "Next colours"},
    {Action::wireframe, GLFW_KEY_Z, plain, "Z", "Edges only"},
    {Action::axes, GLFW_KEY_X, plain, "X", "Axes"},
    {Action::sleep, GLFW_KEY_L, plain, "L", "Sleeping bodies pale"},
    {Action::ghost, GLFW_KEY_H, plain, "H", "Ghost of the other branch"},
    {Action::plots, GLFW_KEY_F4, plain, "F4", "Plots"},
    {Action::panels, GLFW_KEY_TAB, plain, "Tab", "Panels"},
    {Action::help, GLFW_KEY_F1, plain, "F1", "Help"},
    {Action::help, GLFW_KEY_SLASH, shift, "", ""},
    {Action::fullscreen, GLFW_KEY_F11, plain, "F11", "Full screen"},
    {Action::screenshot, GLFW_KEY_P, ctrl, "Ctrl+P", "Picture into out/"},
    {Action::movie, GLFW_KEY_V, plain, "V", "Movie into out/, stop"},
    {Action::record, GLFW_KEY_R, ctrl | shift, "Ctrl+Shift+R", "Record into out/, stop"},
    {Action::cancel, GLFW_KEY_ESCAPE, plain, "Esc", "Cancel: deselect, close the help"},
    {Action::quit, GLFW_KEY_Q, ctrl, "Ctrl+Q", "Quit"},
};

}

std::span<const Binding> bindings() { return all; }

const Binding* find_binding(int key, int mods) {
  const int used = mods & (GLFW_MOD_SHIFT | GLFW_MOD_CONTROL | GLFW_MOD_ALT);
  const auto b =
      std::find_if(std::begin(all), std::end(all), [&](const Binding& i) { return i.key == key && i.mods == used; });
  return b == std::end(all) ? nullptr : b;
}

const Binding& binding_of(Action action) {
  return *std::find_if(std::begin(all), std::end(all), [&](const Binding& b) { return b.action == action; });
}

std::string key_name(int key) {
  if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return {char('a' + key - GLFW_KEY_A)};
  if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return {char('0' + key - GLFW_KEY_0)};
  switch (key) {
    case GLFW_KEY_UP:
      return "up";
    case GLFW_KEY_DOWN:
      return "down";
    case GLFW_KEY_LEFT:
      return "left";
    case GLFW_KEY_RIGHT:
      return "right";
    case GLFW_KEY_SPACE:
      return "space";
    case GLFW_KEY_ENTER:
      return "enter";
    case GLFW_KEY_LEFT_SHIFT:
      return "shift";
    default:
      return {};
  }
}

}
