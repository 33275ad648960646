#include "io/mesh/read.h"

#include <algorithm>
#include <cstdio>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

std::string ending_of(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return ending;
}

std::string measured(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

}

Surface read_surface(Source& source, const std::string& file, std::span<const std::byte> bytes) {
  const std::string ending = ending_of(file);
  if (ending == ".obj") return read_obj(source, file, bytes);
  if (ending == ".stl") return read_stl(source, file, bytes);
  if (ending == ".ply") return read_ply(source, file, bytes);
  throw FileError({file, 0, ""}, "\"" + ending + "\" is no mesh that can be read: .obj, .stl and .ply are");
}

Model read_mesh(Source& source) {
  const std::string file = source.file().string();
  Surface raw = read_surface(source, file, source.bytes());
  if (raw.triangles.empty()) throw FileError({file, 0, ""}, "has no triangles");
  Vec3d low = raw.vertices[raw.triangles[0]], high = low;
  for (const std::uint32_t v : raw.triangles) low = min(low, raw.vertices[v]), high = max(high, raw.vertices[v]);
  const double unit = source.options().unit > 0 ? source.options().unit : 1, size = max_component(high - low) * unit;
  if (source.options().unit == 0 && size > 10) {
    source.warn({}, "is " + measured(size) +
                        " m large, as such files do not say their unit: --unit mm if it is in millimetres");
  }
  for (Vec3d& v : raw.vertices) v = v * unit;
  const Cleaned clean = cleaned(raw);
  if (const std::string gone = what_is_gone(clean); !gone.empty()) source.note({}, gone);
  if (clean.inside_out) source.note({}, "was inside out, and is turned");
  if (clean.surface.triangles.empty()) throw FileError({file, 0, ""}, "has no triangle with an area");

  Model model{.name = source.file().stem().string()};
  BodyDef def{.name = model.name};
  if (clean.solid) {
    def.shape = hull_of(clean.surface);
    const std::string excess = excess_of_hull(def.shape, *clean.solid);
    if (!excess.empty()) {
      source.warn({}, "is not convex: it collides as its convex hull, which " + excess +
                          "; its mass, centre and inertia are its own");
      const Inertial own = inertial_of(*clean.solid, clean.solid->volume * double(def.density));
      def.mass = Real(own.mass), def.center = convert<Real>(own.center);
      def.inertia = Mat3{convert<Real>(own.inertia.c0), convert<Real>(own.inertia.c1), convert<Real>(own.inertia.c2)};
    }
  } else {
    source.note({}, "is open: it stands in the way, and does not fall");
    def.shape = mesh_of(clean.surface);
    def.motion = Motion::fixed;
  }
  // What falls lands on a floor that touches it from below.
  model.bodies.push_back({std::move(def), {file, 0, ""}, model.name});
  if (clean.solid) {
    model.bodies.push_back(
        {BodyDef{.shape = half_space(), .at = {0, low.y * unit, 0}, .motion = Motion::fixed, .name = "floor"},
         {},
         "floor"});
  }
  model.forces.push_back({Gravity{}, {}, ""});
  return model;
}

}
