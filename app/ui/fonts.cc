#include "ui/fonts.h"

#include <imgui.h>

#include <filesystem>

namespace sudar::ui {

namespace {

constexpr float size = 15;  // pixels
constexpr ImWchar signs[] = {
    0x0020, 0x017f,  // Latin
    0x0370, 0x03ff,  // Greek
    0x0400, 0x052f,  // Cyrillic
    0x2000, 0x209f,  // dashes, raised and lowered digits
    0x2100, 0x214f,  // letters as signs
    0x2190, 0x21ff,  // arrows
    0x2200, 0x22ff,  // mathematics
    0x25a0, 0x25ff,  // triangles, squares
    0,
};

void add(const char* file, bool merge) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return;
  ImFontConfig config;
  config.MergeMode = merge;
  config.OversampleH = 2;
  ImGui::GetIO().Fonts->AddFontFromFileTTF(file, size, &config, signs);
}

void set_colours() {
  ImGui::StyleColorsDark();
  ImGuiStyle& s = ImGui::GetStyle();
  s.WindowRounding = 0;
  s.FrameRounding = 4;
  s.GrabRounding = 4;
  s.WindowBorderSize = 0;
  s.WindowPadding = {10, 8};
  s.Colors[ImGuiCol_WindowBg] = {0.09f, 0.10f, 0.12f, 1};
  s.Colors[ImGuiCol_PopupBg] = {0.11f, 0.12f, 0.14f, 0.97f};
  s.Colors[ImGuiCol_MenuBarBg] = {0.12f, 0.13f, 0.15f, 1};
  s.Colors[ImGuiCol_FrameBg] = {0.18f, 0.20f, 0.23f, 1};
  s.Colors[ImGuiCol_Header] = {0.22f, 0.34f, 0.50f, 1};
  s.Colors[ImGuiCol_Button] = {0.20f, 0.25f, 0.32f, 1};
}

}

void load_fonts() {
  set_colours();
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  add("/usr/share/fonts/opentype/inter/Inter-Regular.otf", false);
  add("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", !atlas.Fonts.empty());
  if (atlas.Fonts.empty()) atlas.AddFontDefault();
}

}
