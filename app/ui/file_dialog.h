// Chooses a file, to open or to save: folders and files of one kind to click on, and a field for the path.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ui/places.h"

namespace sudar::ui {

class FileDialog {
 public:
  explicit FileDialog(Places& places) : places_(places) {}
  using Chosen = std::function<void(const std::string& path)>;
  // `path`: a folder, or a name that is offered; empty: where it was last.
  void open(const std::string& title, const std::string& path, const std::string& extension, bool must_exist, Chosen);
  void close() { open_ = false; }
  void draw();

 private:
  void list_folder();
  void confirm();
  Places& places_;
  bool open_ = false, begins_ = false, must_exist_ = false;
  std::string title_, folder_, extension_, reason_;
  std::vector<std::string> folders_, files_;  // names
  char name_[256] = "";
  Chosen chosen_;
};

}
