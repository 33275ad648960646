#include "ui/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "ui/engine_panel.h"
#include "ui/labels.h"

namespace sudar::ui {

namespace {

constexpr float side = 300, line = 30;  // pixels: of the left panel, of the state line
constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

bool begin_panel(const char* name, float x, float y, float width, float height, ImGuiWindowFlags more = 0) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({width, height});
  return ImGui::Begin(name, nullptr, (plain & ~ImGuiWindowFlags_NoScrollbar) | more);
}

// A note over the picture, as large as its text.
void begin_note(const char* name, float x, float y, ImVec2 pivot, ImGuiWindowFlags more = ImGuiWindowFlags_NoInputs) {
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(0.75f);
  ImGui::Begin(name, nullptr, plain | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | more);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return text;
}

// How well a scenario answers a search: 0 not at all, most where its name is what was typed. Enter takes the best, so
// that "wall" is not "seven cubes between walls".
int match(const ScenarioEntry& e, const std::string& search) {
  const std::string name = lower(e.name);
  if (name == search) return 4;
  if (name.starts_with(search)) return 3;
  if ((name + " " + lower(e.place)).find(search) != std::string::npos) return 2;
  return lower(e.about).find(search) != std::string::npos ? 1 : 0;
}

}

void Panels::item(Action action, const bool* on) {
  const Binding& b = binding_of(action);
  if (ImGui::MenuItem(b.does, b.shortcut, on && *on)) controls_.perform(action);
  controls_.places.note(b.does);
}

bool Panels::open_menu(const char* name) {
  const bool open = ImGui::BeginMenu(name);
  if (!open) controls_.places.note(name);
  return open;
}

void Panels::colours(view::Style& style) {
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

void Panels::menu() {
  if (open_menu("Run")) {
    for (const Action a : {Action::pause, Action::step, Action::ten_steps, Action::restart}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::faster, Action::slower, Action::real_time}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::previous, Action::next, Action::search}) item(a);
    ImGui::Separator();
    for (const Action a : {Action::record, Action::screenshot, Action::movie, Action::quit}) item(a);
    ImGui::EndMenu();
  }
  if (open_menu("Edit")) {
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
    item(Action::panels, &controls_.panels), item(Action::fullscreen), item(Action::help, &controls_.help);
    ImGui::EndMenu();
  }
}

void Panels::transport() {
  const auto button = [&](const char* text, Action action) {
    if (ImGui::SmallButton(text)) controls_.perform(action);
    controls_.places.note(std::string("button: ") + binding_of(action).does);
    if (ImGui::IsItemHovered()) {
      const Binding& b = binding_of(action);
      ImGui::SetTooltip("%s (%s)", b.does, b.shortcut);
    }
  };
  const View& v = controls_.view();
  ImGui::Separator();
  button(v.paused ? "▶ Run" : "■ Pause", Action::pause);
  button("→ Step", Action::step);
  button("↺ Restart", Action::restart);
  ImGui::Separator();
  button("−", Action::slower);
  ImGui::Text("×%g", v.speed);
  button("+", Action::faster);
  if (controls_.moment() && controls_.moment()->recording) { ImGui::TextColored({1, 0.35f, 0.3f, 1}, "● recording"); }
}

void Panels::scenarios() {
  if (!ImGui::CollapsingHeader("Scenarios", ImGuiTreeNodeFlags_DefaultOpen)) return;
  if (std::exchange(controls_.wants_search, false)) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##search", "Search (Ctrl+K)", search_, sizeof search_,
                                                ImGuiInputTextFlags_EnterReturnsTrue);
  controls_.places.note("search");
  const std::string search = lower(search_);
  ImGui::BeginChild("list", {0, 230}, false);
  std::string group;
  const ScenarioEntry* best = nullptr;
  for (const ScenarioEntry* e : controls_.catalogue().all()) {
    const int quality = match(*e, search);
    if (quality == 0) continue;
    if (best == nullptr || quality > match(*best, search)) best = e;
    const std::string place = e->place, own = place.substr(0, place.find('/'));
    if (own != group) ImGui::TextDisabled("%s", own.c_str());
    group = own;
    const bool current = controls_.moment() && controls_.moment()->entry == e;
    const bool clicked =
        ImGui::Selectable(("   " + place.substr(place.find('/') + 1) + "##" + e->name).c_str(), current);
    controls_.places.note(std::string("scenario: ") + e->name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", e->about);
    if (clicked) controls_.start(*e);
  }
  if (entered && best != nullptr) controls_.start(*best);
  ImGui::EndChild();
}

void Panels::parameters() {
  const Moment* m = controls_.moment();
  if (!m || m->params.empty() || !ImGui::CollapsingHeader("Parameters", ImGuiTreeNodeFlags_DefaultOpen)) return;
  if (edited_run_ != m->run) edited_.clear(), edited_run_ = m->run;
  ImGui::PushID(m->entry);
  ImGui::PushItemWidth(130);
  bool settled = false;
  for (const Params::Entry& p : m->params) {
    const auto known = edited_.find(p.name);
    double value = known == edited_.end() ? p.value : known->second;
    bool changed = false;
    if (p.kind == Params::Kind::boolean) {
      bool on = value != 0;
      changed = ImGui::Checkbox(p.name.c_str(), &on);
      value = on ? 1 : 0;
      settled = settled || changed;
    } else if (p.kind == Params::Kind::integer) {
      int n = int(value);
      changed = ImGui::SliderInt(p.name.c_str(), &n, int(p.low), int(p.high), "%d", ImGuiSliderFlags_AlwaysClamp);
      value = n;
    } else {
      const auto flags =
          ImGuiSliderFlags_AlwaysClamp | (p.low > 0 && p.high / p.low > 1000 ? ImGuiSliderFlags_Logarithmic : 0);
      changed = ImGui::SliderScalar(p.name.c_str(), ImGuiDataType_Double, &value, &p.low, &p.high, "%.4g", flags);
    }
    if (changed) edited_[p.name] = value;
    controls_.places.note(p.name);
    settled = settled || ImGui::IsItemDeactivatedAfterEdit();
    if (!p.about.empty() && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", p.about.c_str());
  }
  ImGui::PopItemWidth();
  ImGui::PopID();
  if (settled && !edited_.empty()) {
    std::map<std::string, double> all;
    for (const Params::Entry& p : m->params) all[p.name] = edited_.count(p.name) ? edited_[p.name] : p.value;
    controls_.restart_with(all);
  }
  ImGui::TextDisabled("a change restarts");
}

void Panels::engine() {
  const Moment* m = controls_.moment();
  if (!m || !ImGui::CollapsingHeader("Engine", ImGuiTreeNodeFlags_DefaultOpen)) return;
  Config config = m->config;
  if (edit_config(config, controls_.places)) controls_.set_config(config);
}

void Panels::selection() {
  const Moment* m = controls_.moment();
  if (!m || !m->selected || !ImGui::CollapsingHeader("Selected", ImGuiTreeNodeFlags_DefaultOpen)) return;
  const BodyFacts& b = *m->selected;
  ImGui::Text("body %u  %s%s", b.body.index, b.name.c_str(), b.asleep ? "  asleep" : "");
  ImGui::Text("m  %.4g kg", b.mass);
  ImGui::Text("x  %.4g  %.4g  %.4g m", b.pose.p.x, b.pose.p.y, b.pose.p.z);
  ImGui::Text("v  %.3g  %.3g  %.3g m/s", double(b.velocity.x), double(b.velocity.y), double(b.velocity.z));
  ImGui::Text("ω  %.3g  %.3g  %.3g rad/s", double(b.spin.x), double(b.spin.y), double(b.spin.z));
  ImGui::Text("kinetic energy  %.4g J", b.energy);
}

void Panels::state_line(float width, float height, double frames_per_second) {
  begin_panel("state", 0, height - line, width, line, ImGuiWindowFlags_NoScrollbar);
  if (const Moment* m = controls_.moment()) {
    const View& v = controls_.view();
    ImGui::Text(
        "%s   t = %.2f s   %s   ×%.2f real time   %zu bodies   %zu joints   %zu contacts   "
        "step %.0f µs   Σ energy %.5g J   %.0f fps",
        m->entry->name, m->time, v.paused ? "paused" : "running", v.paused ? 0.0 : v.rate, m->bodies, m->joints,
        m->contacts, m->step_us, m->energy.total(), frames_per_second);
  }
  ImGui::End();
}

// What colours and arrows mean in numbers.
void Panels::legend(float right, float top) {
  const view::Style& style = controls_.style;
  const bool speed = style.colouring == view::Colouring::speed, forces = style.forces;
  if (!speed && !forces) return;
  begin_note("legend", right, top, {1, 0});
  if (speed) ImGui::Text("colour: 0 … %g m/s", double(view::top_speed(controls_.scene)));
  if (forces && controls_.scene.metres_per_newton > 0) {
    ImGui::Text("1 m of arrow is %.3g N", 1 / double(controls_.scene.metres_per_newton));
  }
  ImGui::End();
}

void Panels::over_picture(const Area& area) {
  const auto left = float(area.x) + 12, top = float(area.y) + 12;
  const Moment* m = controls_.moment();
  if (m && !m->keys.empty()) {
    begin_note("keys", left, top, {0, 0});
    ImGui::TextDisabled(controls_.view().paused ? "keys of this scenario, while it runs" : "keys of this scenario");
    for (const KeyHelp& k : m->keys) ImGui::Text("%-12s %s", k.key, k.does);
    ImGui::End();
  }
  legend(float(area.x + area.width) - 12, top);
  const View& v = controls_.view();
  if (v.messages != seen_message_) seen_message_ = v.messages, message_since_ = Clock::now();
  if (v.messages > 0 && Clock::now() - message_since_ < std::chrono::seconds(6)) {
    begin_note("message", left, float(area.y + area.height) - 12, {0, 1});
    ImGui::TextUnformatted(v.message.c_str());
    ImGui::End();
  }
}

void Panels::help(const Area& area) {
  begin_note("help", float(area.x) + float(area.width) / 2, float(area.y) + float(area.height) / 2, {0.5f, 0.5f});
  const auto row = [](const char* what, const char* does) {
    ImGui::TableNextColumn(), ImGui::TextUnformatted(what);
    ImGui::TableNextColumn(), ImGui::TextDisabled("%s", does);
  };
  if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
    for (const Binding& b : bindings()) {
      if (*b.shortcut) row(b.shortcut, b.does);
    }
    row("left on a body", "select, drag with a spring");
    row("Ctrl + left", "twist the body");
    row("left beside, middle", "turn the camera");
    row("right, Shift + middle", "slide the camera");
    row("wheel", "closer, away");
    row("right + WASD QE", "fly");
    ImGui::EndTable();
  }
  ImGui::End();
}

Area Panels::draw(int width, int height, double frames_per_second) {
  const auto w = float(width), h = float(height);
  Area area{0, 0, width, height};
  controls_.places.clear();
  controls_.typing = ImGui::GetIO().WantTextInput;
  if (controls_.panels) {
    if (ImGui::BeginMainMenuBar()) {
      menu();
      transport();
      area.y = int(ImGui::GetWindowHeight());
      ImGui::EndMainMenuBar();
    }
    const auto top = float(area.y);
    begin_panel("side", 0, top, side, h - top - line);
    scenarios();
    parameters();
    selection();
    engine();
    ImGui::End();
    state_line(w, h, frames_per_second);
    area = {int(side), area.y, std::max(1, width - int(side)), std::max(1, height - area.y - int(line))};
  }
  if (controls_.labels) draw_labels(controls_, area);
  over_picture(area);
  if (controls_.help) help(area);
  return area;
}

}
