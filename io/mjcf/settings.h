// What an MJCF file says of itself as a whole: units, how things are turned, where masses come from, what is switched
// off.
#pragma once

#include "io/articulation.h"
#include "io/mjcf/file.h"

namespace sudar::inline SUDAR_PRECISION::io {

struct MjcfSettings {
  enum class Inertia { from_geoms, given, automatic };  // automatic: given where it is
  bool degrees = true;
  std::string euler = "xyz";  // axes, each after the other; capitals: axes that stay
  Inertia inertia = Inertia::automatic;
  bool auto_limits = true;  // a range is a limit
  bool balance = false;     // an inertia of no body is replaced without a word
  bool drop_looks = false;  // what touches nothing is left out
  double least_mass = 0, least_inertia = 0, total_mass = 0;
  double first_group = 0, last_group = 5;  // of the geoms that have a mass
  std::string mesh_folder{};
  // <option>
  double timestep = 0.002;  // s
  Vec3d gravity{0, 0, -9.81};
  bool contacts = true, limits = true, equalities = true, friction = true, springs = true, dampers = true,
       actuators = true;
};

MjcfSettings mjcf_settings(const MjcfFile&, Remarks&);

double angle(const MjcfSettings&, double given);  // rad
// The attributes of how something is turned; none of them: not at all.
Quatd orientation(const MjcfSettings&, Fields&);
// `pos` and those.
Frame placement(const MjcfSettings&, Fields&);

}
