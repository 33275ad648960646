#include "ui/places.h"

#include <imgui.h>

namespace sudar::ui {

void Places::note(const std::string& name) {
  if (!ImGui::IsItemVisible()) return;
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  all_[name] = {int(low.x), int(low.y), int(high.x), int(high.y)};
}

}
