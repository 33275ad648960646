// Separating directions by search, as the oracle of curved shapes: how far two bodies are apart is the largest
// separation over all directions. Supports are written down here a second time, in double.
#pragma once

#include "support.h"

namespace sudar::test {

struct Solid {
  Shape shape;
  Mat3d turn;
  Vec3d at;
  Solid(const Shape& s, const Transform& t) : shape(s), turn(wide_matrix(t.q)), at(wide(t.p)) {}

  double reach(const Vec3d& d) const {  // the largest d·x
    const Vec3d u = transpose(turn) * d;
    const double r = shape.radius(), h = shape.half_length(), across = r * std::hypot(u.x, u.z);
    double local = 0;
    switch (shape.kind()) {
      case ShapeKind::sphere:
        local = r * length(u);
        break;
      case ShapeKind::capsule:
        local = r * length(u) + h * std::abs(u.y);
        break;
      case ShapeKind::cylinder:
        local = across + h * std::abs(u.y);
        break;
      case ShapeKind::cone:
        local = std::max(1.5 * h * u.y, across - 0.5 * h * u.y);
        break;
      case ShapeKind::ellipsoid:
        local = length(scale(wide(shape.radii()), u));
        break;
      default:
        local = -1e300;
        for (const Vec3& v : shape.vertices()) local = std::max(local, dot(wide(v), u));
    }
    return dot(at, d) + local;
  }
};

// n of length 1, from b to a.
inline double apart_along(const Solid& a, const Solid& b, const Vec3d& n) { return -a.reach(-n) - b.reach(n); }

struct Best {
  double separation = -1e300;
  Vec3d normal;
};

// From a lattice on the sphere, the best few of which climb in ever smaller steps.
inline Best search(const Solid& a, const Solid& b, int lattice = 600, int climbs = 6) {
  std::vector<Best> starts;
  for (int i = 0; i < lattice; ++i) {
    const double z = 1 - (2 * i + 1.0) / lattice, turn = 2.399963229728653 * i, r = std::sqrt(1 - z * z);
    const Vec3d n{r * std::cos(turn), z, r * std::sin(turn)};
    starts.push_back({apart_along(a, b, n), n});
  }
  std::sort(starts.begin(), starts.end(), [](const Best& p, const Best& q) { return p.separation > q.separation; });
  Best best;
  for (int k = 0; k < climbs; ++k) {
    Best now = starts[std::size_t(k)];
    double stride = 0.15;
    for (int step = 0; stride > 1e-9 && step < 300; ++step) {
      const Vec3d u = any_perpendicular(now.normal), v = cross(now.normal, u);
      Best next = now;
      for (int j = 0; j < 12; ++j) {
        const double t = j * pi / 6;
        const Vec3d n = normalize(now.normal + (u * std::cos(t) + v * std::sin(t)) * stride);
        const double s = apart_along(a, b, n);
        if (s > next.separation) next = {s, n};
      }
      if (next.separation > now.separation)
        now = next;
      else
        stride *= 0.5;
    }
    if (now.separation > best.separation) best = now;
  }
  return best;
}

inline double true_separation(const Solid& a, const Solid& b) { return search(a, b).separation; }

// A random shape with a curved surface, of the size 1. (Sizes in braces: the order in which arguments are evaluated is
// the compiler's own.)
inline Shape random_curved(Random& random) {
  const auto size = [&] { return Real(random.uniform(0.2, 1.2)); };
  const int kind = random.below(4);
  const Vec3 sizes{size(), size(), size()};
  switch (kind) {
    case 0:
      return cylinder(sizes.x, sizes.y);
    case 1:
      return cone(sizes.x, sizes.y);
    case 2:
      return ellipsoid(sizes);
    default:
      return cylinder(sizes.x, Real(0.08) * sizes.y);  // a coin
  }
}

inline Shape random_convex(Random& random) {
  const int kind = random.below(6);
  const Vec3 sizes{Real(random.uniform(0.2, 1)), Real(random.uniform(0.2, 1)), 0};
  switch (kind) {
    case 0:
      return sphere(sizes.x);
    case 1:
      return capsule(sizes.x, sizes.y);
    case 2:
    case 3:
      return random_hull(random);
    default:
      return random_curved(random);
  }
}

}
