// Meshes of convex hulls, with rounded edges and faces in two tones.
#include <limits>
#include <map>

#include "view/mesh.h"

namespace sudar::view {

namespace {

using Loop = std::vector<std::uint32_t>;

struct HullFace {
  Loop loop;
  Vec3f normal{}, centre{};
  float perimeter = 0;
  float tone = 0;
};

// Which face runs through the directed edge from → to.
using EdgeOwners = std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t>;

std::pair<std::uint32_t, std::uint32_t> edge_of(const Loop& loop, std::size_t i) {
  return {loop[i], loop[(i + 1) % loop.size()]};
}

HullFace make_face(const Loop& loop, std::span<const Vec3> points) {
  HullFace face{.loop = loop};
  Vec3f twice_area;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const auto [from, to] = edge_of(loop, i);
    const Vec3f a = to_float(points[from]), b = to_float(points[to]);
    twice_area += cross(a - to_float(points[loop[0]]), b - to_float(points[loop[0]]));
    face.centre += a / float(loop.size());
    face.perimeter += length(b - a);
  }
  face.normal = normalize(twice_area);
  return face;
}

// Greedy: each face takes the tone that fewer of its neighbours (by length of the common edge) and opposites have.
void choose_tones(std::vector<HullFace>& faces, const EdgeOwners& owner, std::span<const Vec3> points) {
  for (std::size_t f = 0; f < faces.size(); ++f) {
    HullFace& face = faces[f];
    float cost[2] = {0, 0};
    for (std::size_t i = 0; i < face.loop.size(); ++i) {
      const auto [from, to] = edge_of(face.loop, i);
      const auto other = owner.find({to, from});
      if (other == owner.end() || other->second >= f) continue;
      const float share = length(to_float(points[to] - points[from])) / face.perimeter;
      cost[int(faces[other->second].tone)] += share;
    }
    for (std::size_t g = 0; g < f; ++g) {
      if (dot(face.normal, faces[g].normal) < -0.999f) cost[int(faces[g].tone)] += 2;  // outweighs all neighbours
    }
    face.tone = cost[1] < cost[0] ? 1.0f : 0.0f;
  }
}

std::vector<HullFace> faces_of(const Shape& shape, EdgeOwners& owner) {
  std::vector<HullFace> faces;
  for (const Loop& loop : shape.faces()) {
    for (std::size_t i = 0; i < loop.size(); ++i) owner[edge_of(loop, i)] = faces.size();
    faces.push_back(make_face(loop, shape.vertices()));
  }
  choose_tones(faces, owner, shape.vertices());
  return faces;
}

// One fan round the face's centre, a triangle per edge.
void add_fan(Mesh& mesh, const HullFace& face, const std::vector<HullFace>& faces, const EdgeOwners& owner,
             std::span<const Vec3> points, float rounding) {
  constexpr float smooth = 0.9f;  // cosine: edges that bend less than 26° are left as they are
  for (std::size_t i = 0; i < face.loop.size(); ++i) {
    const auto [from, to] = edge_of(face.loop, i);
    const Vec3f a = to_float(points[from]), b = to_float(points[to]);
    const auto other = owner.find({to, from});
    const Vec3f beyond = other == owner.end() ? face.normal : faces[other->second].normal;
    const bool sharp = dot(face.normal, beyond) < smooth;
    const float distance = length(cross(normalize(b - a), face.centre - a));
    const Vec3f edge_normal = sharp ? normalize(face.normal + beyond) : face.normal;
    const float on_edge = sharp ? 0.0f : 1.0f, at_centre = sharp ? distance / rounding : 1.0f;
    const auto first = std::uint32_t(mesh.vertices.size());
    mesh.vertices.push_back({face.centre, face.normal, edge_normal, at_centre, face.tone});
    mesh.vertices.push_back({a, face.normal, edge_normal, on_edge, face.tone});
    mesh.vertices.push_back({b, face.normal, edge_normal, on_edge, face.tone});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
}

}

Mesh plain_hull_mesh(const Shape& shape) {
  EdgeOwners owner;
  Mesh mesh;
  for (const HullFace& face : faces_of(shape, owner)) {
    const auto first = std::uint32_t(mesh.vertices.size());
    for (const std::uint32_t i : face.loop) {
      mesh.vertices.push_back({to_float(shape.vertices()[i]), face.normal, face.normal, 1, face.tone});
    }
    for (std::uint32_t i = 2; i < face.loop.size(); ++i) {
      mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
    }
  }
  return mesh;
}

Mesh hull_mesh(const Shape& shape) {
  const std::span<const Vec3> points = shape.vertices();
  EdgeOwners owner;
  const std::vector<HullFace> faces = faces_of(shape, owner);
  // Rounding looks right at a share of the hull's thickness, and is never more than a share of its size.
  float thickness = std::numeric_limits<float>::infinity();
  for (const HullFace& face : faces) {
    float depth = 0;
    for (const Vec3& p : points) depth = max(depth, dot(face.normal, face.centre - to_float(p)));
    thickness = min(thickness, depth);
  }
  const float rounding = 0.09f * thickness;
  Mesh mesh;
  for (const HullFace& face : faces) add_fan(mesh, face, faces, owner, points, rounding);
  return mesh;
}

}
