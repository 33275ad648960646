#include "io/gltf/geometry.h"

#include <sudar/solids.h>

#include <cmath>

namespace sudar::inline SUDAR_PRECISION::io::gltf {

namespace {

constexpr int slices = 32;  // of round things that become hulls

bool alike(double a, double b) { return abs(a - b) <= 1e-5 * max(abs(a), abs(b)); }
// How a scaled cylinder's cross-section stays round; how all stays as it was, but larger.
bool round(const Vec3d& s) { return alike(s.x, s.z); }
bool uniform(const Vec3d& s) { return alike(s.x, s.y) && alike(s.y, s.z); }

// Rings of a surface of revolution about y: radius and height of each.
std::vector<Vec3d> rings(const std::vector<std::pair<double, double>>& profile) {
  std::vector<Vec3d> points;
  for (const auto& [radius, y] : profile) {
    for (int i = 0; i < (radius > 0 ? slices : 1); ++i) {
      const double angle = 2 * pi * i / slices;
      points.push_back({radius * cos(angle), y, radius * sin(angle)});
    }
  }
  return points;
}

// The hull of two spheres on the y axis, as rings.
std::vector<Vec3d> capsule_points(double bottom, double top, double height) {
  const double lean = clamp((bottom - top) / height, -1.0, 1.0);  // sine of the side's lean
  std::vector<std::pair<double, double>> profile;
  constexpr int steps = 8;
  for (const bool upper : {false, true}) {
    const double radius = upper ? top : bottom, center = (upper ? 0.5 : -0.5) * height, side = asin(lean);
    for (int i = 0; i <= steps; ++i) {
      const double from = upper ? side : -pi / 2, to = upper ? pi / 2 : side, angle = from + (to - from) * i / steps;
      profile.emplace_back(max(0.0, radius * cos(angle)), center + radius * sin(angle));
    }
  }
  return rings(profile);
}

double positive_number(const JsonValue& value, double otherwise) {
  const double x = value.number(otherwise);
  if (!(x > 0)) value.refuse("must be greater than 0");
  return x;
}

// What an implicit shape is without scale.
struct Implicit {
  std::string type{};
  Vec3d size{};                            // of a box
  double bottom = 0, top = 0, height = 0;  // of a cylinder or capsule; a sphere's radius is `bottom`

  std::vector<Vec3d> points() const {
    std::vector<Vec3d> list;
    if (type == "box") {
      for (int i = 0; i < 8; ++i) list.push_back(scale(size, {i & 1 ? .5 : -.5, i & 2 ? .5 : -.5, i & 4 ? .5 : -.5}));
      return list;
    }
    if (type == "cylinder") return rings({{bottom, -height / 2}, {top, height / 2}});
    return type == "sphere" ? capsule_points(bottom, bottom, 1e-9) : capsule_points(bottom, top, height);
  }
  // Exact; none of a box, whose hull is exact, too.
  std::optional<MassProperties> mass() const {
    if (type == "sphere") return mass_of(solid::Sphere{bottom});
    if (type == "cylinder" && alike(bottom, top)) return mass_of(solid::Cylinder{bottom, height});
    if (type == "cylinder") {  // whose solids stand on y = 0
      const bool apex_down = bottom == 0;
      MassProperties m = bottom == 0 || top == 0 ? mass_of(solid::Cone{max(bottom, top), height})
                                                 : mass_of(solid::Frustum{bottom, top, height});
      m.center.y = (m.center.y - height / 2) * (apex_down ? -1 : 1);
      return m;
    }
    if (type == "capsule" && alike(bottom, top)) return mass_of(solid::Capsule{bottom, height});
    if (type == "capsule") return mass_of(solid::TaperedCapsule{bottom, top, height});
    return {};
  }
};

Implicit read_implicit(const JsonValue& def, const std::string& type) {
  Implicit s{.type = type};
  const JsonValue own = def[type];
  if (type == "sphere") s.bottom = positive_number(own["radius"], 0.5);
  if (type == "box") {
    s.size = own["size"].vector({1, 1, 1});
    if (!(s.size.x > 0 && s.size.y > 0 && s.size.z > 0)) own["size"].refuse("must be greater than 0 along each axis");
  }
  if (type == "capsule" || type == "cylinder") {
    const double usual = 0.25;
    s.height = positive_number(own["height"], 0.5);
    s.bottom = own["radiusBottom"].number_from(0, usual), s.top = own["radiusTop"].number_from(0, usual);
    if (s.bottom == 0 && s.top == 0) own.refuse("has no radius");
  }
  return s;
}

// The mass of something under a linear map: volumes by its determinant, second moments by the map itself.
MassProperties mapped(const MassProperties& m, const Mat3d& map) {
  const double factor = abs(determinant(map));
  const Mat3d second = Mat3d::identity() * (0.5 * trace(m.inertia)) - m.inertia,
              turned = map * second * transpose(map) * factor;
  return {m.volume * factor, map * m.center, Mat3d::identity() * trace(turned) - turned};
}

}

std::optional<Solid> Geometry::solid(const JsonValue& geometry, const Affine& place, bool dynamic) {
  if (!geometry) geometry.refuse("is left out");
  const Vec3d size = scaling_of(place.m).scale;
  if (size.x == 0 && size.y == 0 && size.z == 0) {
    geometry.note("has a scale of 0, which disables it");
    return {};
  }
  if (size.x == 0 || size.y == 0 || size.z == 0) {
    geometry.warn("has no size along an axis, its scale being 0; left out");
    return {};
  }
  try {
    if (const JsonValue shape = geometry["shape"]) {
      const JsonValue shapes = doc_.root()["extensions"]["KHR_implicit_shapes"]["shapes"];
      return implicit(shapes.element(shape.index(shapes.size())), geometry, place, dynamic);
    }
    // Drafts later than 2025 name the mesh itself.
    Surface surface;
    if (const JsonValue mesh = geometry["mesh"]) {
      add_mesh(doc_.element("meshes", mesh), {}, surface);
    } else if (const JsonValue node = geometry["node"]) {
      surface = this->surface(node.index(tree_.nodes.size()));
    } else {
      geometry.refuse("names neither a shape nor a node");
    }
    for (Vec3d& v : surface.vertices) v = place.m * v;
    if (determinant(place.m) < 0) {
      for (std::size_t t = 0; t + 2 < surface.triangles.size(); t += 3)
        std::swap(surface.triangles[t], surface.triangles[t + 1]);
    }
    std::optional<Solid> made = of_surface(geometry, surface, geometry["convexHull"].flag(false), dynamic);
    if (made) made->at.p = place.t;
    return made;
  } catch (const FileError&) { throw; } catch (const Error& e) {
    geometry.warn(std::string("makes no shape (") + e.what() + "); left out");
    return {};
  }
}

std::optional<Solid> Geometry::plane(const JsonValue& shape, const JsonValue& where, const Affine& place,
                                     bool dynamic) {
  if (dynamic) {
    where.warn("is a plane on a body that falls, which has no mass; left out");
    return {};
  }
  const JsonValue own = shape["plane"];
  const Scaling s = scaling_of(place.m);
  if (!own["sizeX"] && !own["sizeZ"]) {
    if (own["doubleSided"].flag(false)) where.warn("is an infinite plane with two sides; read as solid below");
    return Solid{half_space(), {place.t, s.turn}, {}};
  }
  const double far = 1e4, x = own["sizeX"].number(far) / 2, z = own["sizeZ"].number(far) / 2;
  Surface sheet{{{-x, 0, -z}, {-x, 0, z}, {x, 0, z}, {x, 0, -z}}, {0, 1, 2, 0, 2, 3}};
  for (Vec3d& v : sheet.vertices) v = scale(v, abs(s.scale));
  return Solid{mesh_of(sheet), {place.t, s.turn}, {}};
}

std::optional<Solid> Geometry::implicit(const JsonValue& def, const JsonValue& where, const Affine& place,
                                        bool dynamic) {
  const std::string type = def["type"].text();
  if (type == "plane") return plane(def, where, place, dynamic);
  if (type != "sphere" && type != "box" && type != "capsule" && type != "cylinder") {
    def["type"].warn("\"" + type + "\" is no shape that is known; left out");
    return {};
  }
  doc_.source().count_item();
  const Implicit shape = read_implicit(def, type);
  const Scaling scaling = scaling_of(place.m);
  const Vec3d s = abs(scaling.scale);
  const Frame at{place.t, scaling.turn};
  if (!scaling.shears) {
    if (type == "box") return Solid{box(convert<Real>(scale(shape.size, s))), at, {}};
    if (type == "sphere" && uniform(s)) return Solid{sphere(Real(shape.bottom * s.x)), at, {}};
    if (type == "sphere") return Solid{ellipsoid(convert<Real>(s * shape.bottom)), at, {}};
    const Real bottom = Real(shape.bottom * s.x), top = Real(shape.top * s.x), height = Real(shape.height * s.y);
    if (type == "capsule" && uniform(s) && alike(shape.bottom, shape.top))
      return Solid{capsule(bottom, height), at, {}};
    if (type == "cylinder" && round(s) && alike(shape.bottom, shape.top))
      return Solid{cylinder(bottom, height), at, {}};
    // A cone's origin is its centre of mass, a quarter of the height above its base.
    const Frame up{{0, -0.25 * double(height), 0}, {}}, down{{0, 0.25 * double(height), 0}, {1, 0, 0, 0}};
    if (type == "cylinder" && round(s) && top == 0) return Solid{cone(bottom, height), at * up, {}};
    if (type == "cylinder" && round(s) && bottom == 0) return Solid{cone(top, height), at * down, {}};
  }
  // What has no shape of its own is a hull, with the mass that it should have.
  const Mat3d map = scaling.shears ? place.m : matrix(scaling.turn) * Mat3d::diagonal(s);
  Surface points;
  for (const Vec3d& p : shape.points()) points.vertices.push_back(map * p);
  const std::optional<MassProperties> exact = shape.mass();
  Solid made{hull_of(points), {place.t, {}}, exact ? std::optional(mapped(*exact, map)) : std::nullopt};
  if (type != "box") {
    where.note("a " + type +
               (shape.bottom != shape.top && type != "sphere" ? " with two radii" : " that its scale distorts") +
               " collides as a hull of " + std::to_string(points.vertices.size()) + " points; its mass is exact");
  }
  return made;
}

std::optional<Solid> Geometry::of_surface(const JsonValue& where, const Surface& surface, bool as_hull, bool dynamic) {
  doc_.source().count_item();
  if (as_hull) return Solid{hull_of(surface), {}, {}};
  if (!dynamic) return obstacle(where, surface);
  const Cleaned clean = cleaned(surface);
  Solid made{hull_of(clean.surface), {}, clean.solid};
  if (!clean.solid) {
    where.warn("is an open mesh on a body that falls: its convex hull is taken, for its shape and its mass");
  } else if (const std::string excess = excess_of_hull(made.shape, *clean.solid); !excess.empty()) {
    where.warn("is a mesh that is not convex on a body that falls: it collides as its convex hull, which " + excess +
               "; its mass, centre and inertia are the mesh's");
  } else {
    made.mass.reset();
  }
  return made;
}

Solid Geometry::obstacle(const JsonValue& where, const Surface& surface) {
  const Cleaned clean = cleaned(surface);
  if (const std::string gone = what_is_gone(clean); !gone.empty()) where.note(gone);
  if (clean.inside_out) where.note("was inside out, and is turned");
  if (clean.surface.triangles.empty()) throw Error("", "has no triangles");
  return {mesh_of(clean.surface), {}, {}};
}

Surface Geometry::surface(std::size_t root) {
  Surface all;
  std::vector<std::pair<std::size_t, Affine>> open{{root, Affine{}}};
  for (std::size_t steps = 0; !open.empty(); ++steps) {
    const auto [i, place] = open.back();
    open.pop_back();
    if (steps > tree_.nodes.size()) tree_.nodes[i].json.refuse("goes round in a circle");
    const JsonValue node = tree_.nodes[i].json;
    if (node["skin"]) node["skin"].warn("is not applied: the mesh collides as it is before");
    if (const JsonValue mesh = node["mesh"]) add_mesh(doc_.element("meshes", mesh), place, all);
    for (const JsonValue& child : node["children"].elements()) {
      const std::size_t c = child.index(tree_.nodes.size());
      // What hangs on the node to collide or to be joined is not its mesh.
      if (!tree_.nodes[c].physics()) open.emplace_back(c, place * tree_.nodes[c].local);
    }
  }
  if (all.vertices.empty()) tree_.nodes[root].json.refuse("has no mesh, but its geometry is asked for");
  return all;
}

Surface Geometry::own_surface(std::size_t node) {
  Surface all;
  add_mesh(doc_.element("meshes", tree_.nodes[node].json["mesh"]), {}, all);
  return all;
}

void Geometry::add_mesh(const JsonValue& mesh, const Affine& place, Surface& to) {
  for (const JsonValue& primitive : mesh["primitives"].elements()) {
    if (primitive["extensions"]["KHR_draco_mesh_compression"]) {
      primitive.refuse("is compressed by Draco, which is not supported: export it without compression");
    }
    if (primitive["targets"].size() > 0) primitive["targets"].warn("morph targets are not applied");
    Surface part;
    const JsonValue position = primitive["attributes"]["POSITION"];
    if (!position) {
      primitive.warn("has no POSITION; left out");
      continue;
    }
    const std::vector<double> xyz = doc_.numbers(doc_.element("accessors", position), 3);
    doc_.source().count_vertices(xyz.size() / 3);
    for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
      const Vec3d p = place.point({xyz[i], xyz[i + 1], xyz[i + 2]});
      if (!is_finite(p)) position.refuse("vertex " + std::to_string(i / 3) + " is not finite");
      part.vertices.push_back(p);
    }
    std::vector<std::uint32_t> order;
    if (const JsonValue indices = primitive["indices"]) {
      order = doc_.indices(doc_.element("accessors", indices));
      for (const std::uint32_t v : order) {
        if (v >= part.vertices.size())
          indices.refuse("names vertex " + std::to_string(v) + " of " + std::to_string(part.vertices.size()));
      }
    } else {
      for (std::uint32_t i = 0; i < part.vertices.size(); ++i) order.push_back(i);
    }
    const std::size_t mode = primitive["mode"].whole(4);
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (determinant(place.m) < 0) std::swap(a, b);
      part.triangles.insert(part.triangles.end(), {a, b, c});
    };
    if (mode == 4) {
      for (std::size_t i = 0; i + 2 < order.size(); i += 3) triangle(order[i], order[i + 1], order[i + 2]);
    } else if (mode == 5 || mode == 6) {  // a strip turns every other triangle, a fan has one corner in all
      for (std::size_t i = 0; i + 2 < order.size(); ++i) {
        const bool strip = mode == 5, odd = strip && i % 2 == 1;
        triangle(strip ? order[i + (odd ? 1 : 0)] : order[0], order[i + (odd ? 0 : 1)], order[i + 2]);
      }
    } else {
      primitive["mode"].note("points and lines are left out");
      continue;
    }
    doc_.source().count_triangles(part.triangles.size() / 3);
    to.add(part);
  }
}

}
