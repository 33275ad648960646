#include "io/mjcf/settings.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

void read_compiler(MjcfSettings& s, Fields f) {
  s.degrees = f.choice("angle", s.degrees ? 1 : 0, {"radian", "degree"}) == 1;
  if (f.choice("coordinate", 0, {"local", "global"}) == 1)
    f.fail("coordinate", "global coordinates are not read; MuJoCo has them no more");
  s.euler = f.text("eulerseq", s.euler);
  if (s.euler.size() != 3 || s.euler.find_first_not_of("xyzXYZ") != std::string::npos)
    f.fail("eulerseq", "must be three of x, y, z, X, Y, Z");
  constexpr MjcfSettings::Inertia kinds[] = {MjcfSettings::Inertia::given, MjcfSettings::Inertia::from_geoms,
                                             MjcfSettings::Inertia::automatic};
  s.inertia = kinds[f.choice("inertiafromgeom", 2, {"false", "true", "auto"})];
  s.auto_limits = f.flag("autolimits", s.auto_limits);
  s.balance = f.flag("balanceinertia", s.balance);
  s.drop_looks = f.flag("discardvisual", s.drop_looks);
  s.least_mass = f.number("boundmass", s.least_mass, not_negative);
  s.least_inertia = f.number("boundinertia", s.least_inertia, not_negative);
  s.total_mass = f.number("settotalmass", s.total_mass);
  if (const auto groups = f.numbers("inertiagrouprange", 2, 2); !groups.empty())
    s.first_group = groups[0], s.last_group = groups[1];
  s.mesh_folder = f.text("meshdir", f.text("assetdir", s.mesh_folder));
  f.leave_out("fitaabb", "has no effect: a geom that is fitted to a mesh is the mesh's hull here");
  f.pass({"assetdir", "texturedir", "strippath", "fusestatic", "usethread", "convexhull", "exactmeshinertia",
          "alignfree", "saveinertial", "conflict"});
  f.finish();
}

void read_flags(MjcfSettings& s, Fields f) {
  const auto on = [&](std::string_view name) { return f.choice(name, 1, {"disable", "enable"}) == 1; };
  const bool constraints = on("constraint"), passive = on("passive");
  s.contacts = s.contacts && constraints && on("contact");
  s.limits = s.limits && constraints && on("limit");
  s.equalities = s.equalities && constraints && on("equality");
  s.friction = s.friction && constraints && on("frictionloss");
  s.springs = s.springs && passive && on("spring");
  s.dampers = s.dampers && passive && on("damper");
  s.actuators = s.actuators && on("actuation");
  if (!on("gravity")) s.gravity = {};
  if (!on("filterparent")) f.leave_out("filterparent", "has no effect: links that are joined do not touch here");
  f.pass({"clampctrl", "warmstart", "refsafe", "sensor", "midphase", "eulerdamp", "override", "energy", "fwdinv",
          "invdiscrete", "sensornoise", "multiccd", "island", "nativeccd", "autoreset"});
  f.finish();
}

void read_option(MjcfSettings& s, Remarks& remarks, const XmlElement& e) {
  Fields f(remarks, e);
  s.timestep = f.number("timestep", s.timestep, positive);
  s.gravity = f.vector("gravity", s.gravity);
  const char* no_fluid = "of a medium is not supported: bodies move as in a vacuum";
  for (const char* name : {"density", "viscosity"}) {
    if (f.number(name, 0, not_negative) > 0) f.leave_out(name, no_fluid);
  }
  if (f.vector("wind") != Vec3d{}) f.leave_out("wind", no_fluid);
  if (f.choice("collision", 0, {"all", "predefined", "dynamic"}) != 0)
    f.leave_out("collision", "has no effect: all pairs touch here that may");
  for (const char* name : {"o_margin", "o_solref", "o_solimp", "o_friction"}) f.leave_out(name, "is not supported");
  f.pass({"apirate",
          "impratio",
          "magnetic",
          "integrator",
          "cone",
          "jacobian",
          "solver",
          "iterations",
          "tolerance",
          "ls_iterations",
          "ls_tolerance",
          "noslip_iterations",
          "noslip_tolerance",
          "mpr_iterations",
          "mpr_tolerance",
          "ccd_iterations",
          "ccd_tolerance",
          "sdf_iterations",
          "sdf_initpoints",
          "actuatorgroupdisable"});
  f.finish();
  for (const XmlElement& c : e.children) {
    if (c.name == "flag") read_flags(s, Fields(remarks, c));
  }
}

}

MjcfSettings mjcf_settings(const MjcfFile& file, Remarks& remarks) {
  MjcfSettings settings;
  for (const XmlElement& section : file.root().children) {
    if (section.name == "compiler") read_compiler(settings, Fields(remarks, section));
    if (section.name == "option") read_option(settings, remarks, section);
  }
  return settings;
}

double angle(const MjcfSettings& s, double given) { return s.degrees ? given * (pi / 180) : given; }

Quatd orientation(const MjcfSettings& s, Fields& f) {
  if (f.has("axisangle")) {
    const auto x = f.numbers("axisangle", 4, 4);
    const Vec3d axis{x[0], x[1], x[2]};
    if (!(length(axis) > 1e-9)) f.fail("axisangle", "has no direction");
    return axis_angle(normalize(axis), angle(s, x[3]));
  }
  if (f.has("euler")) {
    const auto x = f.numbers("euler", 3, 3);
    Quatd q;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool stays = s.euler[k] < 'a';
      Vec3d axis;
      axis[s.euler[k] - (stays ? 'X' : 'x')] = 1;
      const Quatd turn = axis_angle(axis, angle(s, x[k]));
      q = stays ? turn * q : q * turn;
    }
    return normalize(q);
  }
  if (f.has("xyaxes")) {
    const auto n = f.numbers("xyaxes", 6, 6);
    const Vec3d x = normalize(Vec3d{n[0], n[1], n[2]}), given{n[3], n[4], n[5]};
    const Vec3d across = given - x * dot(x, given), y = normalize(across);
    if (!(length(x) > 0) || !(length(across) > 1e-9 * length(given))) f.fail("xyaxes", "are no two directions");
    return quaternion(Mat3d{x, y, cross(x, y)});
  }
  if (f.has("zaxis")) return turn_of_z(f.direction("zaxis", {0, 0, 1}));
  if (f.has("quat")) {
    const auto x = f.numbers("quat", 4, 4);
    const Quatd q{x[1], x[2], x[3], x[0]};
    if (!(length_squared(q) > 1e-18)) f.fail("quat", "is zero");
    return normalize(q);
  }
  return {};
}

Frame placement(const MjcfSettings& s, Fields& f) {
  const Vec3d at = f.vector("pos");
  return {at, orientation(s, f)};
}

}
