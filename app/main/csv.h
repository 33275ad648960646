// The course of a run as a table: a row per step. Columns: time, energies, then for each body that the world has at the
// start and that can move its centre of mass and velocity, then the sensors. Units stand in the header. Every row is in
// the file as soon as it is written.
#pragma once

#include <sudar/world.h>

#include "main/files.h"

namespace sudar::app {

class Csv {
 public:
  Csv(const std::string& path, const World&);  // writes the header
  void row(const World&);                      // a body or sensor that is gone leaves its cells empty
  void finish() { file_.finish(); }
  const std::string& path() const { return file_.path(); }

 private:
  GrowingFile file_;
  std::vector<Body> bodies_;
  std::vector<SensorId> sensors_;
};

}
