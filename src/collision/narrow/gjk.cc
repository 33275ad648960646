#include "collision/narrow/gjk.h"

namespace sudar::inline SUDAR_PRECISION {
namespace {

struct Vertex {
  Vec3d w, a, b;  // w = a − b
};

struct Simplex {
  Vertex vertex[4];
  double weight[4];
  int size = 0;

  Vec3d mix(Vec3d Vertex::*part) const {
    Vec3d sum;
    for (int i = 0; i < size; ++i) sum += vertex[i].*part * weight[i];
    return sum;
  }
};

// What is left of a simplex: the vertices whose hull holds the point nearest to the origin, and that point.
struct Nearest {
  int index[4];
  double weight[4];
  int size = 0;
  Vec3d point;
  double squared = std::numeric_limits<double>::infinity();

  void take(const Nearest& other) {
    if (other.squared < squared) *this = other;
  }
};

Nearest on_edge(const Vertex* v, int i, int j) {
  const Vec3d a = v[i].w, along = v[j].w - a;
  const double full = length_squared(along), t = full > 0 ? -dot(a, along) / full : 0;
  Nearest n;
  n.size = 1, n.weight[0] = 1;
  if (!(t > 0)) {
    n.index[0] = i, n.point = a;
  } else if (t >= 1) {
    n.index[0] = j, n.point = v[j].w;
  } else {
    n.size = 2, n.index[0] = i, n.index[1] = j, n.weight[0] = 1 - t, n.weight[1] = t;
    n.point = a + along * t;
  }
  n.squared = length_squared(n.point);
  return n;
}

Nearest on_triangle(const Vertex* v, int i, int j, int k) {
  const Vec3d a = v[i].w, b = v[j].w, c = v[k].w, normal = cross(b - a, c - a);
  const double nn = length_squared(normal);
  // Twice the areas that the origin's foot spans with the sides, times |normal|.
  const double wa = dot(cross(b, c), normal), wb = dot(cross(c, a), normal), wc = dot(cross(a, b), normal);
  if (wa > 0 && wb > 0 && wc > 0 && nn > 1e-28 * square(length_squared(b - a) + length_squared(c - a))) {
    Nearest n;
    n.size = 3;
    n.index[0] = i, n.index[1] = j, n.index[2] = k;
    const double sum = wa + wb + wc;
    n.weight[0] = wa / sum, n.weight[1] = wb / sum, n.weight[2] = wc / sum;
    n.point = normal * (dot(a, normal) / nn);
    n.squared = length_squared(n.point);
    return n;
  }
  Nearest n = on_edge(v, i, j);
  n.take(on_edge(v, j, k));
  n.take(on_edge(v, k, i));
  return n;
}

// Of size 4 if the origin is inside.
Nearest on_tetrahedron(const Vertex* v) {
  constexpr int faces[4][4] = {{0, 1, 2, 3}, {0, 3, 1, 2}, {0, 2, 3, 1}, {1, 3, 2, 0}};  // the last is opposite
  Nearest n;
  bool inside = true;
  for (const int(&f)[4] : faces) {
    const Vec3d a = v[f[0]].w, normal = cross(v[f[1]].w - a, v[f[2]].w - a);
    const double opposite = dot(normal, v[f[3]].w - a), origin = -dot(normal, a);
    const double size = length(normal) * (length(v[f[3]].w - a) + length(a));
    const bool flat = abs(opposite) <= 1e-14 * size;
    if (!flat && opposite * origin > 0) continue;
    inside = false;
    n.take(on_triangle(v, f[0], f[1], f[2]));
  }
  if (inside) n.size = 4, n.squared = 0;
  return n;
}

Nearest nearest(const Simplex& s) {
  const Vertex* v = s.vertex;
  if (s.size == 2) return on_edge(v, 0, 1);
  if (s.size == 3) return on_triangle(v, 0, 1, 2);
  if (s.size == 4) return on_tetrahedron(v);
  Nearest n;
  n.size = 1, n.index[0] = 0, n.weight[0] = 1, n.point = v[0].w, n.squared = length_squared(v[0].w);
  return n;
}

// In the order they have, so that none is overwritten before it is moved.
void keep(const Nearest& n, Simplex& s) {
  int count = 0;
  for (int old = 0; old < s.size; ++old) {
    for (int i = 0; i < n.size; ++i) {
      if (n.index[i] != old) continue;
      if (count != old) s.vertex[count] = s.vertex[old];
      s.weight[count++] = n.weight[i];
    }
  }
  s.size = count;
}

}

Gap gap(const Convex& a, const Convex& b, const Vec3d& shift, const Vec3d& start, double beyond) {
  constexpr int most = 100;
  const double scale = a.radius() + b.radius() + length(a.at - b.at - shift);
  constexpr double digits = sizeof(Real) == sizeof(float) ? 1e-12 : 1e-14;
  const double touch = 1e-11 * scale, enough = digits * scale;
  Gap out;
  Simplex s;
  Vec3d v = start;
  double squared = std::numeric_limits<double>::infinity(), bound = -squared;
  int slivers = 0;
  for (int step = 0; step < most; ++step) {
    const double reach = length(v);
    if (!(reach > (s.size > 0 ? touch : 0))) return out;
    Vertex& next = s.vertex[s.size];
    next.a = a.support(-v);
    next.b = b.support(v) + shift;
    next.w = next.a - next.b;
    const double apart = dot(v, next.w) / reach;  // the plane through w at right angles to v separates by this
    if (apart > bound) bound = apart, out.normal = v / reach;
    if (bound > beyond) {
      out.apart = true, out.distance = bound, out.on_a = next.a, out.on_b = next.b;
      return out;
    }
    if (s.size > 0 && reach - bound <= enough) break;
    bool known = false;
    for (int i = 0; i < s.size; ++i) known |= s.vertex[i].w == next.w;
    ++s.size;
    const Nearest n = nearest(s);
    if (n.size == 4 && !(bound > touch)) return out;
    // No progress, or a tetrahedron so flat that it seems to hold the origin although a plane is known to lie between:
    // the simplex has become a sliver. A new one from here often gets farther.
    if (known || n.size == 4 || !(n.squared < squared)) {
      if (reach - bound <= 1e4 * enough || ++slivers > 2) {
        --s.size;
        break;
      }
      s.vertex[0] = s.vertex[s.size - 1];
      s.size = 1, s.weight[0] = 1;
      v = s.vertex[0].w;
      squared = length_squared(v);
      continue;
    }
    squared = n.squared;
    keep(n, s);
    v = n.point;
  }
  const double distance = length(v);
  if (!(distance > touch)) return out;
  out.apart = true;
  out.distance = distance;
  // The normal is that of the best plane, which proves the distance; v itself is off by a little more where it has just
  // met a long flat side.
  out.on_a = s.mix(&Vertex::a);
  out.on_b = s.mix(&Vertex::b);
  return out;
}

}
