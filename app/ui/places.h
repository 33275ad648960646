// Where the widgets of the panels stand in the picture shown last, by name: for scripts that press them with a real
// mouse
// (--status).
#pragma once

#include <array>
#include <map>
#include <string>

namespace sudar::ui {

class Places {
 public:
  void clear() { all_.clear(); }
  void note(const std::string& name);  // of ImGui's last item, where it is visible
  const std::map<std::string, std::array<int, 4>>& all() const { return all_; }  // left, top, right, bottom, pixels

 private:
  std::map<std::string, std::array<int, 4>> all_;
};

}
