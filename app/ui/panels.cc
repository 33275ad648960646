#include "ui/panels.h"

#include <imgui.h>

#include <algorithm>
#include <cctype>

#include "ui/engine_panel.h"
#include "ui/labels.h"
#include "ui/panes.h"

namespace sudar::ui {

namespace {

constexpr float side = 300, line = 30;  // pixels: of the left panel, of the state line

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
    if (current && std::exchange(listed_, e) != e) ImGui::SetScrollHereY();
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
        m->entry->name, m->time,
        v.paused       ? "paused"
        : m->abandoned ? "running, without its scenario"
                       : "running",
        v.paused ? 0.0 : v.rate, m->bodies, m->joints, m->contacts, m->step_us, m->energy.total(), frames_per_second);
  }
  ImGui::End();
}

void Panels::files() {
  Simulation& s = controls_.simulation();
  constexpr const char* extension = ".run";
  if (std::exchange(controls_.wants_open, false)) {
    file_dialog_.open("Open a saved run", "", extension, true,
                      [&s, &catalogue = controls_.catalogue()](const std::string& path) { s.open(catalogue, path); });
  }
  if (std::exchange(controls_.wants_save, false)) {
    const Moment& m = *controls_.moment();
    file_dialog_.open("Save this run", std::string(m.entry->name) + "-" + std::to_string(m.steps) + extension,
                      extension, false, [&s](const std::string& path) { s.save(path); });
  }
  file_dialog_.draw();
}

Area Panels::draw(int width, int height, double frames_per_second) {
  const auto w = float(width), h = float(height);
  Area area{0, 0, width, height};
  controls_.places.clear();
  controls_.typing = ImGui::GetIO().WantTextInput;
  if (controls_.panels) {
    area.y = menu_bar_.draw();
    const auto top = float(area.y);
    begin_panel("side", 0, top, side, h - top - line);
    scenarios();
    parameters();
    selection();
    engine();
    ImGui::End();
    state_line(w, h, frames_per_second);
    const float plots = controls_.plots ? std::max(130.0f, 0.24f * h) : 0;
    const float below = line + plots + TimelineBar::height;
    timeline_.draw(side, h - below, w - side);
    if (controls_.plots) plot_.draw(side, h - line - plots, w - side, plots);
    area = {int(side), area.y, std::max(1, width - int(side)), std::max(1, height - area.y - int(below))};
  }
  if (controls_.labels) draw_labels(controls_, area);
  notes_.draw(area);
  files();
  return area;
}

}
