#include "ui/notes.h"

#include "ui/panes.h"

namespace sudar::ui {

namespace {

constexpr float margin = 12;  // pixels
constexpr auto message_stays = std::chrono::seconds(6);

// A key or button of the mouse in a table, and what it does.
void row(const char* what, const char* does) {
  ImGui::TableNextColumn(), ImGui::TextColored({0.55f, 0.78f, 1, 1}, "%s", what);
  ImGui::TableNextColumn(), ImGui::TextUnformatted(does);
  ImGui::SameLine(), ImGui::Dummy({margin, 0});  // before the next column
}

}

void Notes::keys(const Area& area) {
  const Moment* m = controls_.moment();
  if (!m || m->keys.empty() || m->abandoned) return;
  begin_note("keys", float(area.x) + margin, float(area.y) + margin, {0, 0});
  ImGui::TextDisabled(controls_.view().paused ? "keys of this scenario, while it runs" : "keys of this scenario");
  if (ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) {
    for (const KeyHelp& k : m->keys) row(k.key, k.does), controls_.places.note(std::string("key: ") + k.key);
    ImGui::EndTable();
  }
  ImGui::End();
}

// What colours and arrows mean in numbers.
void Notes::legend(const Area& area) {
  const view::Style& style = controls_.style;
  const bool speed = style.colouring == view::Colouring::speed, forces = style.forces;
  if (!speed && !forces) return;
  begin_note("legend", float(area.x + area.width) - margin, float(area.y) + margin, {1, 0});
  if (speed) ImGui::Text("colour: 0 … %g m/s", double(view::top_speed(controls_.scene)));
  if (forces && controls_.scene.metres_per_newton > 0) {
    ImGui::Text("1 m of arrow is %.3g N", 1 / double(controls_.scene.metres_per_newton));
  }
  ImGui::End();
}

void Notes::message(const Area& area) {
  const View& v = controls_.view();
  if (v.messages != seen_message_) seen_message_ = v.messages, message_since_ = Clock::now();
  if (v.messages == 0 || Clock::now() - message_since_ > message_stays) return;
  begin_note("message", float(area.x) + margin, float(area.y + area.height) - margin, {0, 1});
  ImGui::TextUnformatted(v.message.c_str());
  ImGui::End();
}

void Notes::help(const Area& area) {
  begin_note("help", float(area.x) + float(area.width) / 2, float(area.y) + float(area.height) / 2, {0.5f, 0.5f});
  if (ImGui::BeginTable("keys", 4, ImGuiTableFlags_SizingFixedFit)) {
    for (const Binding& b : bindings()) {
      if (*b.shortcut) row(b.shortcut, b.does);
    }
    row("→, ←, Shift", "step, step back, ten, when paused");
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

void Notes::draw(const Area& area) {
  keys(area);
  legend(area);
  message(area);
  if (controls_.help) help(area);
}

}
