#include "ui/labels.h"

#include <imgui.h>

#include <algorithm>

namespace sudar::ui {

namespace {

constexpr std::size_t most = 200;  // labels; beyond that nothing could be read

struct Label {
  const view::Instance* instance;
  CameraControl::Seen at;
};

}

void draw_labels(const Controls& controls, const Area& area) {
  std::vector<Label> labels;
  for (const view::Instance& i : controls.scene.instances) {
    if (i.fixed || !i.first) continue;
    const auto at = controls.camera.project(i.pose.p, area.width, area.height);
    if (at && at->x > 0 && at->y > 0 && at->x < area.width && at->y < area.height) labels.push_back({&i, *at});
  }
  if (labels.size() > most) {
    std::nth_element(labels.begin(), labels.begin() + most, labels.end(),
                     [](const Label& a, const Label& b) { return a.at.depth < b.at.depth; });
    labels.resize(most);
  }
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const Label& l : labels) {
    const std::string& name = l.instance->name;
    const std::string text = name.empty() ? std::to_string(l.instance->body.index) : name;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    const ImVec2 corner{float(area.x) + float(l.at.x) - size.x / 2, float(area.y) + float(l.at.y) - size.y / 2};
    list.AddRectFilled({corner.x - 4, corner.y - 1}, {corner.x + size.x + 4, corner.y + size.y + 1},
                       IM_COL32(20, 24, 30, 170), 4);
    list.AddText(corner, IM_COL32(255, 255, 255, 255), text.c_str());
  }
}

}
