// The scenarios that the program offers (plugins, as in thesis §4). Each is a shared library in one folder with one C entry point, sudar_scenario;
// whatever else lies there, or was built for another engine, is refused by name with the reason, and the others are
// offered all the same. What cannot be a library is not even opened: a pipe would wait, a truncated file end the program.
// In a build with SUDAR_STATIC_SCENARIOS they are linked in and there is no folder.
#pragma once

#include <sudar/session.h>

#include <memory>

namespace sudar::app {

class Plugins {
 public:
  // `folder`: empty for the usual one, $SUDAR_SCENARIOS or that of the build tree or of the
  // installation, which is found from where the program is. Throws Error when it
  // cannot be read.
  explicit Plugins(const std::string& folder);

  // Every session made from it must be gone before this object is.
  const Catalogue& catalogue() const { return catalogue_; }
  void open_with(Catalogue::Opener opener) { catalogue_.open_with(std::move(opener)); }  // what is no scenario
  const std::vector<std::string>& refused() const { return refused_; }  // a line for each

 private:
  struct Close {
    void operator()(void* library) const;
  };
  std::vector<std::unique_ptr<void, Close>> libraries_;  // before the catalogue, which points into them
  Catalogue catalogue_;
  std::vector<std::string> refused_;
};

}
