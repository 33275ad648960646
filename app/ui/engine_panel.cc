#include "ui/engine_panel.h"

#include <imgui.h>

namespace sudar::ui {

namespace {

// A widget for each described field. A value takes effect when it is complete (Enter, or leaving the field) and lies
// within the field's range.
struct Editor {
  Places& places;
  bool changed = false;

  static bool within(double v, const Range& r) { return v <= r.high && (r.above ? v > r.low : v >= r.low); }

  void number(const char* name, double& value, const Range& range, const char* format) {
    double v = value;
    ImGui::InputDouble(name, &v, 0, 0, format, ImGuiInputTextFlags_EnterReturnsTrue);
    places.note(name);
    if (ImGui::IsItemDeactivatedAfterEdit() && v != value && within(v, range)) value = v, changed = true;
  }
  void operator()(const char* name, double& value, const Range& range) { number(name, value, range, "%.6g"); }
  void operator()(const char* name, float& value, const Range& range) {
    double v = double(value);
    number(name, v, range, "%.6g");
    if (float(v) != value) value = float(v);
  }
  void operator()(const char* name, std::int32_t& value, const Range& range) {
    double v = value;
    number(name, v, range, "%.0f");
    if (v == double(std::int32_t(v))) value = std::int32_t(v);
  }
  void operator()(const char* name, bool& value, const Range&) {
    changed |= ImGui::Checkbox(name, &value);
    places.note(name);
  }
  template <class E>
  requires std::is_enum_v<E>
  void operator()(const char* name, E& value, const Range&) {
    const char* const* texts = names(value);
    const bool open = ImGui::BeginCombo(name, texts[int(value)]);
    if (!open) return places.note(name);
    for (int i = 0; texts[i]; ++i) {
      if (ImGui::Selectable(texts[i], i == int(value)) && i != int(value)) value = E(i), changed = true;
      places.note(std::string(name) + ": " + texts[i]);
    }
    ImGui::EndCombo();
  }
  template <class T>
  requires std::is_class_v<T>
  void operator()(const char* name, T& part, const Range&) {
    const bool open = ImGui::TreeNode(name);
    places.note(name);
    if (!open) return;
    describe(*this, part);
    ImGui::TreePop();
  }
};

}

bool edit_config(Config& config, Places& places) {
  Editor editor{places};
  ImGui::PushItemWidth(110);
  describe(editor, config);
  ImGui::PopItemWidth();
  return editor.changed;
}

}
