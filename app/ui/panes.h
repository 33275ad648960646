// ImGui's windows as this program has them: without title and frame, where they are put. After each, ImGui::End().
#pragma once

#include <imgui.h>

namespace sudar::ui {

void begin_panel(const char* name, float x, float y, float width, float height, ImGuiWindowFlags more = 0);

// Over the picture, as large as its text. `pivot`: which point of it is at x, y; 0…1.
void begin_note(const char* name, float x, float y, ImVec2 pivot);

}
