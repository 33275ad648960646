#include "world/triangles.h"

#include <algorithm>

#include "geometry/triangle_mesh.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

bool is_mesh(const World::Impl& w, std::uint32_t shape) { return w.geometries[shape]->kind == ShapeKind::mesh; }

// The triangles of mesh m that shape s may meet in the coming sub-step, or step, ascending.
std::vector<std::uint32_t> triangles_near(const World::Impl& w, std::uint32_t m, std::uint32_t s) {
  const Box& box = w.proxies[s].box;
  const Pose& mesh = w.shape_poses[m];
  const Pos middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
  const Vec3 half = box.high - middle, center = mesh.local(middle);
  const Mat3 to_mesh = transpose(matrix(mesh.q));
  const Real more = w.contact_margin(m) + length(w.coming_way(m));
  const Vec3 reach = abs(to_mesh.c0) * half.x + abs(to_mesh.c1) * half.y + abs(to_mesh.c2) * half.z + Vec3{more, more, more};
  std::vector<std::uint32_t> near;
  w.geometries[m]->mesh->search(center - reach, center + reach, [&](std::uint32_t t) { near.push_back(t); });
  std::sort(near.begin(), near.end());
  return near;
}

void list_parts(World::Impl& w, const ProxyPair key) {
  const bool mesh_is_a = is_mesh(w, key.a);
  const std::uint32_t m = mesh_is_a ? key.a : key.b, s = mesh_is_a ? key.b : key.a;
  if (!has_mass(w.geometries[s]->kind) || !w.bodies.dynamic(w.body_of(s))) return;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> parts;  // triangle, pair
  w.pairs.each(s, [&](std::uint32_t p) {
    if (w.pairs[p].key == key && w.pairs[p].part != no_part) parts.emplace_back(w.pairs[p].part, p);
  });
  std::sort(parts.begin(), parts.end());
  const std::vector<std::uint32_t> near = triangles_near(w, m, s);
  for (const auto& [triangle, pair] : parts) {
    if (std::binary_search(near.begin(), near.end(), triangle)) continue;
    if (w.pairs[pair].row != no_row) w.note_touch(key);
    w.end_pair(pair);
  }
  const bool active = w.bodies.moves(w.body_of(s)) || w.bodies.moves(w.body_of(m));
  auto known = parts.begin();
  for (const std::uint32_t triangle : near) {
    while (known != parts.end() && known->first < triangle) ++known;
    if (known != parts.end() && known->first == triangle) continue;
    const std::uint32_t pair = w.pairs.add(key, triangle);
    if (active) w.pairs.activate(pair);
  }
}

}

void list_triangles(World::Impl& w) {
  if (w.meshes.empty()) return;
  std::vector<std::uint32_t> wholes;
  const auto look = [&](std::uint32_t s) {
    w.pairs.each(s, [&](std::uint32_t p) {
      const PairRow& row = w.pairs[p];
      if (row.part == no_part && (is_mesh(w, row.key.a) || is_mesh(w, row.key.b))) wholes.push_back(p);
    });
  };
  for (const std::uint32_t s : w.searched) look(s);
  for (const std::uint32_t i : w.kinematic) {
    if (!w.bodies.slots.used(i)) continue;
    w.bodies.each_shape(i, [&](std::uint32_t s) {
      if (is_mesh(w, s)) look(s);
    });
  }
  std::ranges::sort(wholes, {}, [&](std::uint32_t p) { return w.pairs[p].order(); });
  wholes.erase(std::unique(wholes.begin(), wholes.end()), wholes.end());
  for (const std::uint32_t p : wholes) {
    w.pairs.watches()[p].until = infinite;  // it is its parts that are looked at
    list_parts(w, w.pairs[p].key);
  }
}

}
