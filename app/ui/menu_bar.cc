#include "ui/menu_bar.h"

#include <imgui.h>

namespace sudar::ui {

void MenuBar::item(Action action, const bool* on) {
  const Binding& b = binding_of(action);
  if (ImGui::MenuItem(b.does, b.shortcut, on && *on)) controls_.perform(action);
  controls_.places.note(b.does);
}

bool MenuBar::open_menu(const char* name) {
  const bool open = ImGui::BeginMenu(name);
  if (!open) controls_.places.note(name);
  return open;
}

void MenuBar::colours(view::Style& style) {
  constexpr struct {
    view::Colouring colouring;
    const char* text;
  } all[] = {{view::Colouring::body, "Colour by body"},
             {view::Colouring::speed, "Colour by speed"},
             {view::Colouring::island, "Colour by island"},
             {view::Colouring::sleep, "Colour by sleep"}};
  for (const auto& c : all) {
    if (ImGui::MenuItem(c.text, nullptr, style.colouring == c.colouring)) style.colouring = c.colouring;
    controls_.places.note(c.text);
  }
}

void MenuBar::menus() {
  if (open_menu("File")) {
    for (const Action a : {Action::open, Action::save}) item(a);
    ImGui::EndMenu();
  }
  if (open_menu("Run")) {
    for (const Action a : {Action::pause, Action::step, Action::ten_steps, Action::restart}) item(a);
    for (const Action a : {Action::step_back, Action::ten_steps_back, Action::play_backwards, Action::newest}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::faster, Action::slower, Action::real_time}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::previous, Action::next, Action::search}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::record, Action::screenshot, Action::movie, Action::quit}) item(a);
    ImGui::EndMenu();
  }
  if (open_menu("Edit")) {
    for (const Action a : {Action::undo, Action::redo}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::shoot, Action::add_box, Action::add_sphere, Action::remove}) item(a);
    ImGui::EndMenu();
  }
  if (open_menu("Show")) {
    view::Style& style = controls_.style;
    item(Action::contacts, &style.contacts), item(Action::joints, &style.joints), item(Action::forces, &style.forces);
    item(Action::axes, &style.axes), item(Action::labels, &controls_.labels);
    item(Action::boxes, &style.boxes), item(Action::cells, &style.cells);
    ImGui::Separator();
    colours(style);
    item(Action::colours);
    ImGui::Separator();
    item(Action::wireframe, &style.wireframe), item(Action::sleep, &style.sleep);
    ImGui::Separator();
    for (const Action a : {Action::frame_selection, Action::frame_all}) item(a);
    item(Action::follow, &controls_.follow);
    ImGui::Separator();
    const bool ghost = controls_.moment() && controls_.moment()->ghost;
    item(Action::ghost, &ghost), item(Action::plots, &controls_.plots);
    item(Action::panels, &controls_.panels), item(Action::fullscreen), item(Action::help, &controls_.help);
    ImGui::EndMenu();
  }
}

void MenuBar::transport() {
  const auto button = [&](const char* text, Action action) {
    if (ImGui::SmallButton(text)) controls_.perform(action);
    controls_.places.note(std::string("button: ") + binding_of(action).does);
    if (ImGui::IsItemHovered()) {
      const Binding& b = binding_of(action);
      ImGui::SetTooltip("%s (%s)", b.does, b.shortcut);
    }
  };
  const auto red = [](const char* text) { ImGui::TextColored({1, 0.35f, 0.3f, 1}, "%s", text); };
  const View& v = controls_.view();
  ImGui::Separator();
  button(v.paused ? "▶ Run" : "■ Pause", Action::pause);
  button("→ Step", Action::step);
  button("↺ Restart", Action::restart);
  ImGui::Separator();
  button("−", Action::slower);
  ImGui::Text("×%g", v.speed);
  button("+", Action::faster);
  if (controls_.moment() && controls_.moment()->recording) red("● recording");
  if (controls_.filming) red("● movie");
}

int MenuBar::draw() {
  if (!ImGui::BeginMainMenuBar()) return 0;
  menus();
  transport();
  const int height = int(ImGui::GetWindowHeight());
  ImGui::EndMainMenuBar();
  return height;
}

}
