#include "ui/file_dialog.h"

#include <algorithm>
#include <filesystem>

#include "ui/panes.h"

namespace sudar::ui {

namespace fs = std::filesystem;

void FileDialog::open(const std::string& title, const std::string& path, const std::string& extension, bool must_exist,
                      Chosen chosen) {
  std::error_code error;
  const fs::path last = folder_.empty() ? "." : folder_, given = path.empty() ? last : fs::path(path);
  const bool folder = fs::is_directory(given, error);
  const fs::path place = folder ? given : given.has_parent_path() ? given.parent_path() : last;
  folder_ = fs::absolute(place, error).lexically_normal().string();
  name_[folder ? 0 : given.filename().string().copy(name_, sizeof name_ - 1)] = 0;
  title_ = title, extension_ = extension, must_exist_ = must_exist, chosen_ = std::move(chosen);
  open_ = begins_ = true;
  list_folder();
}

void FileDialog::list_folder() {
  folders_.clear(), files_.clear(), reason_.clear();
  std::error_code error;
  for (fs::directory_iterator i(folder_, error), end; !error && i != end; i.increment(error)) {
    const std::string name = i->path().filename().string();
    if (name.starts_with(".")) continue;
    std::error_code unknown;
    if (i->is_directory(unknown)) folders_.push_back(name);
    if (i->is_regular_file(unknown) && i->path().extension() == extension_) files_.push_back(name);
  }
  if (error) reason_ = folder_ + ": " + error.message();
  std::sort(folders_.begin(), folders_.end());
  std::sort(files_.begin(), files_.end());
}

// A folder's name leads there; a file's is chosen.
void FileDialog::confirm() {
  if (name_[0] == 0) return;
  fs::path path = (fs::path(folder_) / name_).lexically_normal();  // an absolute name stays what it is
  std::error_code error;
  if (fs::is_directory(path, error)) {
    folder_ = path.string(), name_[0] = 0;
    return list_folder();
  }
  if (path.extension().empty()) path += extension_;
  if (must_exist_ && !fs::is_regular_file(path, error)) return void(reason_ = path.string() + " is no file");
  folder_ = path.parent_path().string();
  open_ = false;
  chosen_(path.string());
}

void FileDialog::draw() {
  if (!open_) return;
  if (begins_) ImGui::OpenPopup(title_.c_str());
  const ImVec2 all = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(560.0f, all.x - 40), std::min(420.0f, all.y - 40)});
  bool stays = true;
  if (!ImGui::BeginPopupModal(title_.c_str(), &stays, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
  ImGui::TextUnformatted(folder_.c_str());
  ImGui::BeginChild("files", {0, -70}, true);
  std::string into;
  if (ImGui::Selectable("..")) into = "..";
  places_.note("file: ..");
  for (const std::string& name : folders_) {
    if (ImGui::Selectable((name + "/").c_str())) into = name;
    places_.note("file: " + name + "/");
  }
  bool twice = false;
  for (const std::string& name : files_) {
    if (ImGui::Selectable(name.c_str(), name == name_, ImGuiSelectableFlags_AllowDoubleClick)) {
      name_[name.copy(name_, sizeof name_ - 1)] = 0;
      twice = ImGui::IsMouseDoubleClicked(0);
    }
    places_.note("file: " + name);
  }
  ImGui::EndChild();
  if (!reason_.empty()) ImGui::TextColored({1, 0.5f, 0.4f, 1}, "%s", reason_.c_str());
  if (begins_) ImGui::SetKeyboardFocusHere();
  begins_ = false;
  ImGui::SetNextItemWidth(-170);
  const bool entered = ImGui::InputText("##name", name_, sizeof name_, ImGuiInputTextFlags_EnterReturnsTrue);
  places_.note("file name");
  ImGui::SameLine();
  const bool pressed = ImGui::Button(must_exist_ ? "Open" : "Save", {70, 0});
  places_.note("file: confirm");
  ImGui::SameLine();
  if (ImGui::Button("Cancel", {70, 0}) || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) open_ = false;
  places_.note("file: cancel");
  if (!into.empty()) folder_ = (fs::path(folder_) / into).lexically_normal().string(), list_folder();
  if (entered || pressed || twice) confirm();
  if (!stays) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}
