#include "view/mesh.h"

#include <cmath>
#include <utility>

namespace sudar::view {

namespace {

// A ring of a surface of revolution about y.
struct Ring {
  float radius, y;
  float slope_out, slope_up;  // the normal's part away from the axis and along it
};

// One band between the first and the last ring, in `sectors` pieces of alternating tone.
void revolve(Mesh& mesh, std::span<const Ring> rings, int sectors, int slices, float (*tone)(int sector)) {
  const auto turn = 2 * float(pi) / float(sectors * slices);
  for (int sector = 0; sector < sectors; ++sector) {
    const auto first = std::uint32_t(mesh.vertices.size());
    const auto row = std::uint32_t(slices + 1);
    for (const Ring& ring : rings) {
      for (int i = 0; i <= slices; ++i) {
        const float angle = turn * float(sector * slices + i), c = sudar::cos(angle), s = sudar::sin(angle);
        const Vec3f normal{ring.slope_out * c, ring.slope_up, -ring.slope_out * s};
        mesh.vertices.push_back({{ring.radius * c, ring.y, -ring.radius * s}, normal, normal, 1, tone(sector)});
      }
    }
    for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
      for (std::uint32_t i = 0; i < std::uint32_t(slices); ++i) {
        const std::uint32_t low = first + r * row + i, high = low + row;
        mesh.indices.insert(mesh.indices.end(), {low, low + 1, high + 1, low, high + 1, high});
      }
    }
  }
}

// Part of a sphere's outline between two latitudes [rad], from low to high, its centre at height y.
std::vector<Ring> arc(float radius, float y, float from, float to, int steps) {
  std::vector<Ring> rings;
  for (int i = 0; i <= steps; ++i) {
    const float latitude = from + (to - from) * float(i) / float(steps);
    const float out = sudar::cos(latitude), up = sudar::sin(latitude);
    rings.push_back({radius * out, y + radius * up, out, up});
  }
  return rings;
}

constexpr float quarter = float(pi) / 2;
float alternate(int sector) { return float(sector % 2); }
float alternate_shifted(int sector) { return float((sector + 1) % 2); }
float light(int) { return 1; }
float dark(int) { return 0; }

}

Mesh sphere_mesh(int fineness) {  // a beach ball: eight sectors and two caps
  constexpr float cap = 1.25f;    // latitude, rad
  const int at_cap = (fineness + 1) / 2;
  Mesh mesh;
  revolve(mesh, arc(1, 0, -quarter, -cap, at_cap), 8, fineness, light);
  revolve(mesh, arc(1, 0, -cap, cap, 3 * fineness), 8, fineness, alternate);
  revolve(mesh, arc(1, 0, cap, quarter, at_cap), 8, fineness, light);
  return mesh;
}

namespace {

Mesh capsule_mesh(float radius, float half_length, int fineness) {
  Mesh mesh;
  const int slices = 5 * fineness / 3, rings = 4 * fineness / 3;
  const Ring low{radius, -half_length, 1, 0}, high{radius, half_length, 1, 0};
  revolve(mesh, arc(radius, -half_length, -quarter, 0, rings), 4, slices, alternate_shifted);
  revolve(mesh, std::vector<Ring>{low, high}, 4, slices, alternate);
  revolve(mesh, arc(radius, half_length, 0, quarter, rings), 4, slices, alternate_shifted);
  return mesh;
}

Mesh cylinder_mesh(float radius, float half, int slices) {
  Mesh mesh;
  revolve(mesh, std::vector<Ring>{{0, -half, 0, -1}, {radius, -half, 0, -1}}, 4, slices, alternate_shifted);
  revolve(mesh, std::vector<Ring>{{radius, -half, 1, 0}, {radius, half, 1, 0}}, 4, slices, alternate);
  revolve(mesh, std::vector<Ring>{{radius, half, 0, 1}, {0, half, 0, 1}}, 4, slices, alternate_shifted);
  return mesh;
}

Mesh tapered_mesh(float radius, float base, float apex, int slices) {
  const float height = apex - base, side = std::sqrt(radius * radius + height * height);
  const float out = height / side, up = radius / side;
  Mesh mesh;
  revolve(mesh, std::vector<Ring>{{0, base, 0, -1}, {radius, base, 0, -1}}, 4, slices, alternate_shifted);
  revolve(mesh, std::vector<Ring>{{radius, base, out, up}, {0, apex, out, up}}, 4, slices, alternate);
  return mesh;
}

Mesh stretched(Mesh mesh, const Vec3f& by) {
  for (MeshVertex& v : mesh.vertices) {
    v.position = scale(v.position, by);
    v.normal = v.edge_normal = normalize(Vec3f{v.normal.x / by.x, v.normal.y / by.y, v.normal.z / by.z});
  }
  return mesh;
}

Mesh inside_out(Mesh mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
  for (MeshVertex& v : mesh.vertices) v.normal = -v.normal, v.edge_normal = -v.edge_normal;
  return mesh;
}

}

Mesh smooth_mesh(const Shape& shape, int fineness) {
  const int slices = 2 * fineness;
  const float radius = float(shape.radius()), half = float(shape.half_length());
  switch (shape.kind()) {
    case ShapeKind::capsule:
      return capsule_mesh(radius, half, fineness);
    case ShapeKind::cylinder:
      return cylinder_mesh(radius, half, slices);
    case ShapeKind::cone:
      return tapered_mesh(radius, -half / 2, 1.5f * half, slices);
    case ShapeKind::ellipsoid:
      return stretched(sphere_mesh(fineness), to_float(shape.radii()));
    case ShapeKind::hollow_sphere: {  // its lower half, to let the light in
      Mesh bowl;
      revolve(bowl, arc(radius, 0, -quarter, 0, 16), 8, fineness, alternate);
      return inside_out(std::move(bowl));
    }
    case ShapeKind::hollow_cylinder: {
      Mesh pipe;
      revolve(pipe, std::vector<Ring>{{radius, -half, 1, 0}, {radius, half, 1, 0}}, 4, slices, alternate);
      return inside_out(std::move(pipe));
    }
    default:
      return {};
  }
}

Mesh stick_mesh() {
  Mesh mesh;
  revolve(mesh, std::vector<Ring>{{1, 0, 1, 0}, {1, 1, 1, 0}}, 1, 12, dark);
  revolve(mesh, std::vector<Ring>{{1, 1, 0, 1}, {0, 1, 0, 1}}, 1, 12, dark);
  return mesh;
}

Mesh cone_mesh() {
  Mesh mesh;
  const float slope = std::sqrt(0.5f);
  revolve(mesh, std::vector<Ring>{{0, 0, 0, -1}, {1, 0, 0, -1}}, 1, 16, dark);
  revolve(mesh, std::vector<Ring>{{1, 0, slope, slope}, {0, 1, slope, slope}}, 1, 16, dark);
  return mesh;
}

Mesh cube_outline() {
  Mesh mesh;
  mesh.lines = true;
  for (std::uint32_t i = 0; i < 8; ++i) {
    const Vec3f corner{float(i & 1), float(i >> 1 & 1), float(i >> 2)};
    mesh.vertices.push_back({corner, {0, 1, 0}, {0, 1, 0}, 1, 0});
    for (const std::uint32_t axis : {1u, 2u, 4u}) {
      if ((i & axis) == 0) mesh.indices.insert(mesh.indices.end(), {i, i | axis});
    }
  }
  return mesh;
}

}
