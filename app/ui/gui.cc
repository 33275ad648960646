#include "ui/gui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "ui/fonts.h"

namespace sudar::ui {

namespace {

// A panel that a key or a click calls may need so many frames until it stands where it will and takes what comes next.
constexpr int frames_to_answer = 3;

void name_keys(ImGuiIO& io) {
  constexpr struct {
    ImGuiKey_ name;
    int key;
  } keys[] = {{ImGuiKey_Tab, GLFW_KEY_TAB},
              {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},
              {ImGuiKey_RightArrow, GLFW_KEY_RIGHT},
              {ImGuiKey_UpArrow, GLFW_KEY_UP},
              {ImGuiKey_DownArrow, GLFW_KEY_DOWN},
              {ImGuiKey_PageUp, GLFW_KEY_PAGE_UP},
              {ImGuiKey_PageDown, GLFW_KEY_PAGE_DOWN},
              {ImGuiKey_Home, GLFW_KEY_HOME},
              {ImGuiKey_End, GLFW_KEY_END},
              {ImGuiKey_Insert, GLFW_KEY_INSERT},
              {ImGuiKey_Delete, GLFW_KEY_DELETE},
              {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE},
              {ImGuiKey_Space, GLFW_KEY_SPACE},
              {ImGuiKey_Enter, GLFW_KEY_ENTER},
              {ImGuiKey_KeyPadEnter, GLFW_KEY_KP_ENTER},
              {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
              {ImGuiKey_A, GLFW_KEY_A},
              {ImGuiKey_C, GLFW_KEY_C},
              {ImGuiKey_V, GLFW_KEY_V},
              {ImGuiKey_X, GLFW_KEY_X},
              {ImGuiKey_Y, GLFW_KEY_Y},
              {ImGuiKey_Z, GLFW_KEY_Z}};
  for (const auto& k : keys) io.KeyMap[k.name] = k.key;
}

}

Gui::Gui(Window& window) : window_(window) {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;  // the layout is fixed: there is nothing to remember
  io.SetClipboardTextFn = [](void*, const char* text) { glfwSetClipboardString(nullptr, text); };
  io.GetClipboardTextFn = [](void*) { return glfwGetClipboardString(nullptr); };
  name_keys(io);
  load_fonts();
  ImGui_ImplOpenGL3_Init("#version 330");
}

Gui::~Gui() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Gui::take(const std::vector<InputEvent>& events) {
  for (const InputEvent& e : events) {
    const bool moves = e.kind == InputEvent::Kind::move;
    if (moves && !queue_.empty() && queue_.back().kind == InputEvent::Kind::move) queue_.pop_back();
    queue_.push_back(e);
  }
}

void Gui::feed(const InputEvent& e) {
  ImGuiIO& io = ImGui::GetIO();
  const auto point = [&] { io.MousePos = {float(e.x), float(e.y)}; };
  switch (e.kind) {
    case InputEvent::Kind::move:
      return point();
    case InputEvent::Kind::button:
      point();
      if (e.code >= 0 && e.code < IM_ARRAYSIZE(io.MouseDown)) io.MouseDown[e.code] = e.down;
      return;
    case InputEvent::Kind::wheel:
      io.MouseWheel += float(e.y);
      return;
    case InputEvent::Kind::character:
      return io.AddInputCharacter(unsigned(e.code));
    case InputEvent::Kind::key: {
      if (e.code < 0 || e.code >= IM_ARRAYSIZE(io.KeysDown)) return;
      io.KeysDown[e.code] = e.down;
      const auto either = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
      io.KeyCtrl = either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
      io.KeyShift = either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
      io.KeyAlt = either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
      return;
    }
  }
}

// Releases and movements pass: what went down over the picture must come up there.
bool Gui::wanted_by_panels(const InputEvent& e) const {
  const ImGuiIO& io = ImGui::GetIO();
  switch (e.kind) {
    case InputEvent::Kind::key:
      return e.down && (io.WantTextInput || io.WantCaptureKeyboard);  // the latter: a dialog is open
    case InputEvent::Kind::button:
      return e.down && io.WantCaptureMouse;
    case InputEvent::Kind::wheel:
      return io.WantCaptureMouse;
    case InputEvent::Kind::move:
      return false;
    case InputEvent::Kind::character:
      return true;
  }
  return true;
}

std::optional<InputEvent> Gui::begin() {
  std::optional<InputEvent> event;
  if (answering_ > 0) {
    --answering_;
  } else if (!queue_.empty()) {
    event = queue_.front();
    queue_.pop_front();
    feed(*event);
    if (event->down || event->kind == InputEvent::Kind::button) answering_ = frames_to_answer;
  }
  ImGuiIO& io = ImGui::GetIO();
  const double now = glfwGetTime();
  io.DeltaTime = float(now - last_ > 1e-6 ? now - last_ : 1e-6);
  last_ = now;
  io.DisplaySize = {float(window_.width()), float(window_.height())};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  if (event && wanted_by_panels(*event)) event.reset();
  return event;
}

void Gui::end() { ImGui::EndFrame(); }

void Gui::draw() {
  ImGui::Render();
  window_.target();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}
