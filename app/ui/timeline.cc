#include "ui/timeline.h"

#include <algorithm>

#include "ui/panes.h"

namespace sudar::ui {

namespace {

struct Kind {
  std::uint8_t bit;
  const char* name;
  ImU32 colour;
  float high;  // share of the strip
};

// Later ones are drawn over earlier ones.
constexpr Kind kinds[] = {{Mark::touch, "contacts begin", IM_COL32(120, 130, 145, 255), 0.25f},
                          {Mark::hit, "hits", IM_COL32(230, 140, 40, 255), 0.4f},
                          {Mark::sleep, "bodies fall asleep", IM_COL32(90, 130, 230, 255), 0.6f},
                          {Mark::wake, "bodies wake", IM_COL32(235, 215, 90, 255), 0.6f},
                          {Mark::edit, "edits", IM_COL32(80, 220, 120, 255), 1.0f},
                          {Mark::quarantine, "bodies put in quarantine", IM_COL32(255, 60, 60, 255), 1.0f}};

}

void TimelineBar::buttons(const Moment& m) {
  const auto button = [&](const char* text, Action action) {
    if (ImGui::SmallButton(text)) controls_.perform(action);
    controls_.places.note(std::string("timeline: ") + binding_of(action).does);
    const Binding& b = binding_of(action);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s (%s)", b.does, b.shortcut);
    ImGui::SameLine();
  };
  button(controls_.view().backwards ? "■" : "◀", Action::play_backwards);
  button("←", Action::step_back);
  button("→", Action::step);
  button("▶|", Action::newest);
  const Timeline& t = m.timeline;
  ImGui::Text("%lld / %lld  %.1f MB", static_cast<long long>(t.here.frame), static_cast<long long>(t.end),
              double(t.bytes) / 1e6);
  if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("step, of those that are known, from %lld on; memory of the history",
                      static_cast<long long>(t.begin));
  }
  ImGui::SameLine();
}

void TimelineBar::branches(const Moment& m) {
  const Timeline& t = m.timeline;
  const auto current = std::find_if(t.branches.begin(), t.branches.end(),
                                    [&](const History::Branch& b) { return b.number == t.here.branch; });
  if (current == t.branches.end()) return;
  Simulation& s = controls_.simulation();
  ImGui::SetNextItemWidth(100);
  const bool open = ImGui::BeginCombo("##branch", current->name.c_str());
  if (!open) controls_.places.note("branch");
  if (open) {
    for (const History::Branch& b : t.branches) {
      const std::string text = b.name + "   steps " + std::to_string(b.from) + " to " + std::to_string(b.end) + "##" +
                               std::to_string(b.number);
      if (ImGui::Selectable(text.c_str(), &b == &*current)) s.go_to_branch(b.number);
      controls_.places.note("branch: " + b.name);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  if (ImGui::SmallButton("Rename")) {
    name_[current->name.copy(name_, sizeof name_ - 1)] = 0;
    ImGui::OpenPopup("rename");
  }
  controls_.places.note("rename branch");
  if (ImGui::BeginPopup("rename")) {
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputText("##name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue) && name_[0] != 0) {
      s.post([number = current->number, name = std::string(name_)](History& h) { h.rename(number, name); });
      ImGui::CloseCurrentPopup();
    }
    controls_.places.note("branch name");
    ImGui::EndPopup();
  }
  if (t.branches.size() < 2) return;
  ImGui::SameLine();
  if (ImGui::SmallButton("Delete others")) {
    s.post([](History& h) {
      for (const History::Branch& b : h.branches()) {
        if (b.number != h.here().branch) h.remove(b.number);
      }
    });
  }
  controls_.places.note("delete other branches");
  ImGui::SameLine();
  bool ghost = m.ghost;
  if (ImGui::Checkbox("ghost", &ghost)) s.show_ghost(ghost);
  controls_.places.note("ghost");
  ImGui::SameLine();
  const auto of = std::find_if(t.branches.begin(), t.branches.end(),
                               [&](const History::Branch& b) { return b.number == m.ghost_of; });
  ImGui::SetNextItemWidth(80);
  if (!ImGui::BeginCombo("##ghost", of == t.branches.end() ? "" : of->name.c_str())) return;
  for (const History::Branch& b : t.branches) {
    if (b.number == t.here.branch) continue;
    if (ImGui::Selectable((b.name + "##" + std::to_string(b.number)).c_str(), b.number == m.ghost_of))
      s.show_ghost_of(b.number);
  }
  ImGui::EndCombo();
}

void TimelineBar::strip(const Moment& m) {
  const Timeline& t = m.timeline;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, tall = 18;
  ImGui::InvisibleButton("strip", {width, tall});
  controls_.places.note("timeline");
  const double frames = double(std::max<std::int64_t>(1, t.end - t.begin));
  const auto x_of = [&](std::int64_t frame) { return at.x + float(double(frame - t.begin) / frames) * width; };
  const float share = std::clamp((ImGui::GetIO().MousePos.x - at.x) / width, 0.0f, 1.0f);
  const std::int64_t pointed = t.begin + std::int64_t(double(share) * frames + 0.5);
  if (ImGui::IsItemActive()) {
    if (pointed != asked_) controls_.simulation().go(asked_ = pointed);
  } else {
    asked_ = -1;
  }
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + width, at.y + tall}, IM_COL32(38, 42, 50, 255), 3);
  draw.AddRectFilled(at, {x_of(t.here.frame), at.y + tall}, IM_COL32(48, 66, 92, 255), 3);
  std::uint8_t under = 0;
  if (m.chart) {
    for (const Kind& k : kinds) {
      for (std::size_t i = 0; i < m.chart->marks.size(); ++i) {
        if ((m.chart->marks[i] & k.bit) == 0) continue;
        const float x = at.x + (float(i) + 0.5f) / float(mark_parts) * width;
        draw.AddLine({x, at.y + tall}, {x, at.y + tall * (1 - k.high)}, k.colour);
      }
    }
    under = m.chart->marks[std::size_t(std::min(share, 0.9999f) * float(mark_parts))];
  }
  const float here = x_of(t.here.frame);
  draw.AddTriangleFilled({here - 6, at.y - 2}, {here + 6, at.y - 2}, {here, at.y + 7}, IM_COL32(255, 255, 255, 255));
  draw.AddLine({here, at.y}, {here, at.y + tall}, IM_COL32(255, 255, 255, 255), 1.5f);
  if (!ImGui::IsItemHovered() && !ImGui::IsItemActive()) return;
  ImGui::BeginTooltip();
  ImGui::Text("step %lld", static_cast<long long>(pointed));
  for (const Kind& k : kinds) {
    if (under & k.bit) ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(k.colour), "%s", k.name);
  }
  ImGui::EndTooltip();
}

void TimelineBar::draw(float x, float y, float width) {
  begin_panel("timeline", x, y, width, height, ImGuiWindowFlags_NoScrollbar);
  if (const Moment* m = controls_.moment()) buttons(*m), branches(*m), strip(*m);
  ImGui::End();
}

}
