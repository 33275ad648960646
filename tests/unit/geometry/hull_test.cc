// The hull builder against Qhull, an independent program, and against what a hull is by definition.
#include "geometry/hull.h"

#include "unit/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

using namespace sudar;
using sudar_test::Random;

namespace {

using Points = std::vector<Vec3>;

struct Measures {
  double volume = 0, area = 0;
  std::set<std::size_t> vertices;  // numbers of points
};

Measures qhull(const Points& points) {
  std::vector<double> coordinates;
  for (const Vec3& p : points) coordinates.insert(coordinates.end(), {double(p.x), double(p.y), double(p.z)});
  qhT state;
  qh_zero(&state, nullptr);
  char options[] = "qhull Pp";
  const int failed = qh_new_qhull(&state, 3, int(points.size()), coordinates.data(), False, options, nullptr, nullptr);
  Measures m;
  if (!failed) {
    qh_getarea(&state, state.facet_list);
    m.volume = state.totvol;
    m.area = state.totarea;
    for (vertexT* v = state.vertex_list; v && v->next; v = v->next)
      m.vertices.insert(std::size_t(qh_pointid(&state, v->point)));
  }
  qh_freeqhull(&state, !qh_ALL);
  int kept, total;
  qh_memfreeshort(&state, &kept, &total);
  EXPECT_FALSE(failed) << "Qhull itself failed";
  return m;
}

Measures measure(const Polyhedron& p) {
  Measures m;
  for (const Polyhedron::Face& face : p.faces) {
    Vec3d area;
    const auto corner = [&](std::uint32_t i) { return convert<double>(p.vertices[p.loops[face.first + i]]); };
    for (std::uint32_t i = 2; i < face.count; ++i)
      area += cross(corner(i - 1) - corner(0), corner(i) - corner(0)) * 0.5;
    m.area += length(area);
    m.volume += dot(area, corner(0) - convert<double>(p.interior)) / 3;
  }
  return m;
}

double largest(const Points& points) {
  Real m = 0;
  for (const Vec3& p : points) m = max(m, max_component(abs(p)));
  return double(m);
}

// What a hull is: vertices are points, every point is below every face, faces are counter-clockwise and their edges
// close.
void expect_hull(const Polyhedron& p, const Points& points) {
  const double tolerance = 3 * flatness_tolerance(points);
  for (const Vec3& v : p.vertices) ASSERT_NE(std::find(points.begin(), points.end(), v), points.end());
  double worst = 0;
  for (const Polyhedron::Face& face : p.faces) {
    ASSERT_NEAR(double(length(face.normal)), 1, 1e-6);
    for (const Vec3& x : points) {
      worst = std::max(worst, dot(convert<double>(face.normal), convert<double>(x)) - double(face.offset));
    }
  }
  EXPECT_LE(worst, tolerance);
  EXPECT_EQ(p.vertices.size() + p.faces.size(), p.edges.size() + 2);
  for (const Polyhedron::Edge& e : p.edges) {
    const auto runs = [&](std::uint32_t face, std::uint32_t from, std::uint32_t to) {
      const Polyhedron::Face& f = p.faces[face];
      for (std::uint32_t i = 0; i < f.count; ++i) {
        if (p.loops[f.first + i] == from && p.loops[f.first + (i + 1) % f.count] == to) return true;
      }
      return false;
    };
    EXPECT_TRUE(runs(e.left, e.from, e.to) && runs(e.right, e.to, e.from));
  }
}

void expect_same(const Polyhedron& p, const Points& points) {
  const Measures exact = qhull(points), ours = measure(p);
  const double tolerance = 3 * flatness_tolerance(points), size = 2 * largest(points);
  EXPECT_NEAR(ours.volume, exact.volume, 1e-12 * exact.volume + tolerance * exact.area);
  EXPECT_NEAR(ours.area, exact.area, 1e-12 * exact.area + 20 * tolerance * size);
}

Polyhedron check(const Points& points) {
  const Polyhedron p = convex_hull(points);
  expect_hull(p, points);
  expect_same(p, points);
  return p;
}

Points cloud(int count, const std::function<Vec3d()>& make) {
  Points points;
  for (int i = 0; i < count; ++i) points.push_back(convert<Real>(make()));
  return points;
}

Points grid(int n) {
  Points points;
  for (int i = 0; i < n * n * n; ++i) points.push_back({Real(i % n), Real(i / n % n), Real(i / n / n)});
  return points;
}

void expect_counts(const Polyhedron& p, std::size_t vertices, std::size_t faces) {
  EXPECT_EQ(p.vertices.size(), vertices);
  EXPECT_EQ(p.faces.size(), faces);
}

TEST(Hull, RandomPointsHaveQhullsVertices) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Points points = cloud(int(4 + seed * 5), [&] { return random.in_cube(10); });
    const Polyhedron p = check(points);
    std::set<std::size_t> vertices;
    for (const Vec3& v : p.vertices)
      vertices.insert(std::size_t(std::find(points.begin(), points.end(), v) - points.begin()));
    EXPECT_EQ(vertices, qhull(points).vertices);
  }
}

TEST(Hull, PointsOnASphereAreAllVertices) {
  Random random(7);
  const Points points = cloud(1000, [&] { return random.direction(); });
  expect_counts(check(points), 1000, 2 * 1000 - 4);
}

TEST(Hull, GridsAreBoxes) {
  for (int n = 2; n <= 9; ++n) expect_counts(check(grid(n)), 8, 6);
}

TEST(Hull, TurnedGridsAreBoxesInSpiteOfRounding) {
  Random random(3);
  for (int i = 0; i < 40; ++i) {
    const Quatd q = random.rotation();
    const Vec3d shift = random.in_cube(20),
                stretch{random.between(0.1, 3), random.between(0.1, 3), random.between(0.1, 3)};
    Points points;
    for (const Vec3& p : grid(4))
      points.push_back(convert<Real>(rotate(q, scale(convert<double>(p), stretch)) + shift));
    expect_counts(check(points), 8, 6);
  }
}

TEST(Hull, IntegerPointsOnOneSphere) {
  // 5² + 0 + 0 = 3² + 4² + 0, 9² = 8² + 4² + 1² …: many points on one sphere, many of them on circles.
  for (const int r2 : {25, 50, 81, 169, 425}) {
    Points points;
    for (int x = -21; x <= 21; ++x) {
      for (int y = -21; y <= 21; ++y) {
        for (int z = -21; z <= 21; ++z) {
          if (x * x + y * y + z * z == r2) points.push_back({Real(x), Real(y), Real(z)});
        }
      }
    }
    SCOPED_TRACE(points.size());
    EXPECT_EQ(check(points).vertices.size(), points.size());
  }
}

TEST(Hull, DuplicatesChangeNothing) {
  Random random(5);
  Points points = cloud(50, [&] { return random.in_cube(); });
  const Polyhedron once = convex_hull(points);
  for (int i = 0; i < 500; ++i) points.push_back(points[std::size_t(random.whole(0, 49))]);
  const Polyhedron twice = check(points);
  EXPECT_EQ(once.vertices, twice.vertices);
  EXPECT_EQ(once.loops, twice.loops);
}

TEST(Hull, NearDuplicates) {
  Random random(6);
  const double tiny = double(std::numeric_limits<Real>::epsilon());
  for (int i = 0; i < 50; ++i) {
    Points points;
    for (int k = 0; k < 8; ++k) {
      const Vec3d corner{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
      for (int m = 0; m < 6; ++m) points.push_back(convert<Real>(corner + random.in_cube(2 * tiny)));
    }
    const Polyhedron p = check(points);
    EXPECT_EQ(p.faces.size(), 6u);
  }
}

TEST(Hull, NearlyCoplanar) {
  // A cube whose faces are covered with points that bulge by noise from far below to far above the tolerance.
  Random random(8);
  for (double noise = 1e-18; noise < 1e-1; noise *= 3) {
    SCOPED_TRACE(noise);
    Points points;
    for (int i = 0; i < 300; ++i) {
      Vec3d p = random.in_cube();
      const int axis = i % 3;
      p[axis] = (i % 2 ? 1 : -1) * (1 + random.between(-noise, noise));
      points.push_back(convert<Real>(p));
    }
    for (int k = 0; k < 8; ++k) points.push_back({Real(k & 1 ? 1 : -1), Real(k & 2 ? 1 : -1), Real(k & 4 ? 1 : -1)});
    const Polyhedron p = check(points);
    if (noise < double(std::numeric_limits<Real>::epsilon())) expect_counts(p, 8, 6);
  }
}

TEST(Hull, CirclesMakeAPrism) {
  for (const int n : {3, 5, 12, 100}) {
    Points points;
    for (int i = 0; i < 2 * n; ++i) {
      const double angle = 2 * pi * (i / 2) / n;
      points.push_back(convert<Real>(Vec3d{3 * sudar::cos(angle), i % 2 ? 1.0 : -1.0, 3 * sudar::sin(angle)}));
    }
    expect_counts(check(points), std::size_t(2 * n), std::size_t(n + 2));
  }
}

TEST(Hull, HugeAndSmallScales) {
  Random random(9);
  const Points unit = cloud(100, [&] { return random.in_cube(); });
  const Polyhedron reference = convex_hull(unit);
  for (const double factor : {0x1p-60, 0x1p-20, 0x1p20, 0x1p60}) {
    Points points = unit;
    for (Vec3& p : points) p *= Real(factor);
    EXPECT_EQ(convex_hull(points).loops, reference.loops);
  }
}

TEST(Hull, NeedlesAndPlates) {
  Random random(10);
  const Vec3d flat{1, 1, 1e-4}, needle{1e-3, 1e-3, 1};
  for (const Vec3d& stretch : {flat, needle}) {
    for (int i = 0; i < 20; ++i) {
      const Quatd q = random.rotation();
      check(cloud(200, [&] { return rotate(q, scale(random.in_cube(), stretch)); }));
    }
  }
}

TEST(Hull, SmallIntegersMeetEveryDegeneracy) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const int reach = random.whole(1, 4);
    const auto coordinate = [&] { return double(random.whole(-reach, reach)); };
    const Points points = cloud(random.whole(20, 80), [&] { return Vec3d{coordinate(), coordinate(), coordinate()}; });
    check(points);
  }
}

// Without Qhull, which loses corners or gives up on some of these. Nothing is lost: a closed convex surface with
// corners among the points and every point below every face is the hull.
TEST(Hull, NoiseOfEverySizeOnEverything) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const double noise = std::pow(10, random.between(-18, -1));
    const Quatd q = seed % 2 ? random.rotation() : Quatd{};
    const int kind = random.whole(0, 4), count = random.whole(10, 200);
    const Points points = cloud(count, [&] {
      Vec3d p = random.in_cube();
      if (kind == 0) p[random.whole(0, 2)] = random.whole(0, 1) ? 1 : -1;  // on the faces of a cube
      if (kind == 1)
        p = {double(random.whole(0, 1)), double(random.whole(0, 1)), double(random.whole(0, 1))};  // its corners
      if (kind == 2)
        p = scale(normalize(Vec3d{p.x, 0, p.z}), {1, 0, 1}) + Vec3d{0, p.y > 0 ? 1.0 : -1.0, 0};  // on two circles
      if (kind == 3) p = normalize(p);
      if (kind == 4) p.y = (p.x > 0 ? 0.5 : 0.3) * p.x + (random.whole(0, 3) ? 0 : p.y * p.y);  // a lid with a kink
      return rotate(q, p + random.in_cube(noise));
    });
    expect_hull(convex_hull(points), points);
    if (HasFailure()) break;
  }
}

TEST(Hull, FarFromTheOrigin) {
  Random random(11);
  const Vec3d there{300, -700, 500};
  check(cloud(200, [&] { return there + random.in_cube(); }));
}

TEST(Hull, ManyPoints) {
  Random random(12);
  check(cloud(100'000, [&] { return random.in_cube(); }));
}

TEST(Hull, OrderDoesNotMatter) {
  Random random(13);
  Points points = grid(3);
  for (int i = 0; i < 60; ++i) points.push_back(convert<Real>(random.in_cube(3)));
  const auto sorted = [](Points p) {
    std::sort(p.begin(), p.end(),
              [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    return p;
  };
  const Polyhedron reference = convex_hull(points);
  for (int i = 0; i < 20; ++i) {
    for (std::size_t k = points.size() - 1; k > 0; --k)
      std::swap(points[k], points[std::size_t(random.whole(0, int(k)))]);
    const Polyhedron p = convex_hull(points);
    EXPECT_EQ(sorted(p.vertices), sorted(reference.vertices));
    EXPECT_EQ(p.faces.size(), reference.faces.size());
  }
}

void expect_refused(const Points& points, const std::string& reason) {
  try {
    convex_hull(points);
    ADD_FAILURE() << "accepted, although: " << reason;
  } catch (const Error& error) {
    EXPECT_EQ(error.field, "points");
    EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
  }
}

TEST(Hull, RefusesWhatHasNoVolume) {
  expect_refused({}, "four or more");
  expect_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "four or more");
  expect_refused(Points(7, {1, 2, 3}), "one place");
  expect_refused(Points(7, {0, 0, 0}), "one place");
  expect_refused({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {5, 5, 5}, {-3, -3, -3}}, "one line");
  Random random(14);
  const Quatd q = random.rotation();
  expect_refused(cloud(50, [&] { return rotate(q, Vec3d{random.between(-1, 1), 0, 0}); }), "one line");
  expect_refused(cloud(50,
                       [&] {
                         return rotate(q, Vec3d{random.between(-1, 1), 0, random.between(-1, 1)});
                       }),
                 "one plane");
  expect_refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {3, 1, 0}}, "one plane");
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  for (const Real bad : {nan, infinity, -infinity}) {
    for (int axis = 0; axis < 3; ++axis) {
      Points points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      points[3][axis] = bad;
      expect_refused(points, "finite");
    }
  }
}

}
