#include "ui/panes.h"

namespace sudar::ui {

namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

}

void begin_panel(const char* name, float x, float y, float width, float height, ImGuiWindowFlags more) {
  ImGui::SetNextWindowPos({x, y});
  ImGui::SetNextWindowSize({width, height});
  ImGui::Begin(name, nullptr, (plain & ~ImGuiWindowFlags_NoScrollbar) | more);
}

void begin_note(const char* name, float x, float y, ImVec2 pivot) {
  ImGui::SetNextWindowPos({x, y}, ImGuiCond_Always, pivot);
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::Begin(
      name, nullptr,
      plain | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoInputs);
}

}
