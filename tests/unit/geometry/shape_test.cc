// The generators: what they make, where it is, and what they refuse; and what make_geometry fills in.
#include "geometry/geometry.h"

#include "unit/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

using namespace sudar;
using sudar_test::Random;

namespace {

const double tiny = 1e-6;  // a rounding of numbers around 1 to float, and some

struct Named {
  const char* name;
  Shape shape;
  std::size_t vertices, edges, faces;
};

std::vector<Named> polyhedra() {
  const Vec3 outline[] = {{0, 0, 0}, {2, 0, 0}, {3, 1, 0}, {1, 3, 0}, {0, 2, 0}};
  return {{"box", box({1, 2, 3}), 8, 12, 6},
          {"prism", prism(24, 6, 6), 48, 72, 26},
          {"outline", prism(outline, 2), 10, 15, 7},
          {"pyramid", pyramid(12, 40, 10), 13, 24, 13},
          {"cylinder", cylinder(1, 2, 32), 64, 96, 34},
          {"cone", cone(1, 2, 32), 33, 64, 33},
          {"uv_sphere", uv_sphere(1), 24 * 11 + 2, 24 * 23, 24 * 12},
          {"tetrahedron", tetrahedron(2), 4, 6, 4},
          {"octahedron", octahedron(2), 6, 12, 8},
          {"dodecahedron", dodecahedron(2), 20, 30, 12},
          {"icosahedron", icosahedron(2), 12, 30, 20},
          {"truncated_icosahedron", truncated_icosahedron(2), 60, 90, 32},
          {"wedge", wedge({200, 30, 100}), 6, 9, 5}};
}

TEST(Generators, CountsAndAdjacency) {
  for (const Named& n : polyhedra()) {
    SCOPED_TRACE(n.name);
    const Polyhedron& p = n.shape.geometry().hull;
    EXPECT_EQ(n.shape.kind(), ShapeKind::hull);
    EXPECT_EQ(p.vertices.size(), n.vertices);
    EXPECT_EQ(p.edges.size(), n.edges);
    EXPECT_EQ(p.faces.size(), n.faces);
    const double size = double(n.shape.bounding_radius());
    const std::vector<std::vector<std::uint32_t>> faces = n.shape.faces();
    for (std::size_t f = 0; f < p.faces.size(); ++f) {
      const Polyhedron::Face& face = p.faces[f];
      EXPECT_NEAR(double(length(face.normal)), 1, tiny);
      EXPECT_LT(double(dot(face.normal, p.interior) - face.offset), -0.01 * size);
      for (const std::uint32_t v : faces[f]) {
        EXPECT_NEAR(double(dot(face.normal, p.vertices[v]) - face.offset), 0, tiny * size);
      }
      for (const Vec3& v : p.vertices) EXPECT_LT(double(dot(face.normal, v) - face.offset), tiny * size);
    }
    for (const Polyhedron::Edge& e : p.edges) {
      const auto runs = [&](std::uint32_t face, std::uint32_t from, std::uint32_t to) {
        const std::vector<std::uint32_t>& loop = faces[face];
        const auto at = std::find(loop.begin(), loop.end(), from);
        return at != loop.end() && (at + 1 == loop.end() ? loop.front() : at[1]) == to;
      };
      EXPECT_TRUE(runs(e.left, e.from, e.to) && runs(e.right, e.to, e.from));
    }
  }
}

TEST(Generators, CentredOnTheirCentreOfMass) {
  for (const Named& n : polyhedra()) {
    if (n.name == std::string("outline")) continue;
    SCOPED_TRACE(n.name);
    EXPECT_LT(length(n.shape.mass_properties().center), tiny * double(n.shape.bounding_radius()));
  }
}

TEST(Generators, RegularSolidsHaveTheEdgeAskedFor) {
  for (const Shape& s : {tetrahedron(Real(0.7)), octahedron(Real(0.7)), dodecahedron(Real(0.7)), icosahedron(Real(0.7)),
                         truncated_icosahedron(Real(0.7))}) {
    const Polyhedron& p = s.geometry().hull;
    for (const Polyhedron::Edge& e : p.edges)
      EXPECT_NEAR(double(length(p.vertices[e.to] - p.vertices[e.from])), 0.7, tiny);
  }
}

TEST(Generators, AxesAndEnds) {
  const auto holds = [](const Shape& s, const Vec3& corner) {
    return std::any_of(s.vertices().begin(), s.vertices().end(),
                       [&](const Vec3& v) { return double(length(v - corner)) < tiny; });
  };
  EXPECT_TRUE(holds(box({1, 2, 3}), {Real(0.5), 1, Real(-1.5)}));
  EXPECT_TRUE(holds(prism(5, 2, 3), {2, Real(1.5), 0}) && holds(prism(5, 2, 3), {2, Real(-1.5), 0}));
  EXPECT_TRUE(holds(pyramid(5, 2, 4), {2, -1, 0}) && holds(pyramid(5, 2, 4), {0, 3, 0}));
  EXPECT_TRUE(holds(uv_sphere(2), {0, 2, 0}) && holds(uv_sphere(2), {2, 0, 0}));
  EXPECT_TRUE(holds(wedge({3, 6, 2}), {-1, -2, 1}) && holds(wedge({3, 6, 2}), {2, -2, -1}) &&
              holds(wedge({3, 6, 2}), {-1, 4, -1}));
}

TEST(Generators, OutlinesStayWhereTheyAreWhicheverWayTheyRun) {
  std::vector<Vec3> outline{{10, 0, 7}, {14, 0, -3}, {14, 2, 0}, {10, 2, 0}};  // z is ignored
  const MassProperties m = prism(outline, 3).mass_properties();
  std::reverse(outline.begin(), outline.end());
  const MassProperties reversed = prism(outline, 3).mass_properties();
  for (const MassProperties& p : {m, reversed}) {
    EXPECT_NEAR(p.volume, 24, tiny);
    EXPECT_LT(length(p.center - Vec3d{12, 1, 0}), 1e-5);
  }
}

TEST(Generators, SmoothShapes) {
  EXPECT_EQ(sphere(2).kind(), ShapeKind::sphere);
  EXPECT_EQ(sphere(2).radius(), 2);
  EXPECT_EQ(sphere(2).bounding_radius(), 2);
  EXPECT_EQ(capsule(2, 6).half_length(), 3);
  EXPECT_EQ(capsule(2, 6).bounding_radius(), 5);
  EXPECT_EQ(half_space().kind(), ShapeKind::half_space);
  EXPECT_TRUE(std::isinf(half_space().bounding_radius()));
  EXPECT_THROW(half_space().mass_properties(), Error);
  EXPECT_TRUE(sphere(2).faces().empty() && sphere(2).vertices().empty());
}

TEST(Generators, RefuseBadInputAndNameIt) {
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  const auto expect_field = [](const char* field, const std::function<void()>& make) {
    try {
      make();
      ADD_FAILURE() << field << " was accepted";
    } catch (const Error& error) { EXPECT_EQ(error.field, field) << error.what(); }
  };
  for (const Real bad : {Real(0), Real(-1), nan, infinity}) {
    expect_field("radius", [&] { sphere(bad); });
    expect_field("radius", [&] { capsule(bad, 1); });
    expect_field("length", [&] { capsule(1, bad); });
    expect_field("edges", [&] { box({1, bad, 1}); });
    expect_field("radius", [&] { prism(5, bad, 1); });
    expect_field("height", [&] { prism(5, 1, bad); });
    expect_field("radius", [&] { pyramid(5, bad, 1); });
    expect_field("height", [&] { pyramid(5, 1, bad); });
    expect_field("height", [&] { cylinder(1, bad); });
    expect_field("radius", [&] { cone(bad, 1); });
    expect_field("height", [&] { cylinder(1, bad, 9); });
    expect_field("radius", [&] { cone(bad, 1, 9); });
    expect_field("radii.y", [&] { ellipsoid({1, bad, 1}); });
    expect_field("radius", [&] { hollow_sphere(bad); });
    expect_field("height", [&] { hollow_cylinder(1, bad); });
    expect_field("radius", [&] { uv_sphere(bad); });
    expect_field("edge", [&] { tetrahedron(bad); });
    expect_field("edge", [&] { octahedron(bad); });
    expect_field("edge", [&] { dodecahedron(bad); });
    expect_field("edge", [&] { icosahedron(bad); });
    expect_field("edge", [&] { truncated_icosahedron(bad); });
    expect_field("edges", [&] { wedge({1, 1, bad}); });
  }
  for (const int bad : {2, 0, -5, 10'000'000}) {
    expect_field("sides", [&] { prism(bad, 1, 1); });
    expect_field("sides", [&] { pyramid(bad, 1, 1); });
    expect_field("sides", [&] { cylinder(1, 1, bad); });
    expect_field("sides", [&] { cone(1, 1, bad); });
    expect_field("slices", [&] { uv_sphere(1, bad, 4); });
    expect_field("stacks", [&] { uv_sphere(1, 8, bad == 2 ? 1 : bad); });
  }
  expect_field("points", [&] { hull({}); });
}

TEST(Generators, RefuseOutlinesThatAreNotConvex) {
  const auto refused = [](const std::vector<Vec3>& outline) {
    try {
      prism(outline, 1);
      return false;
    } catch (const Error& error) { return error.field == "outline"; }
  };
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  EXPECT_FALSE(refused({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_TRUE(refused({{0, 0, 0}, {1, 0, 0}}));
  EXPECT_TRUE(refused({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));             // no area
  EXPECT_TRUE(refused({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {3, 1, 0}}));  // a dent
  EXPECT_TRUE(refused({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}));  // a bow tie
  EXPECT_TRUE(refused({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}}));  // a corner twice
  EXPECT_TRUE(refused({{0, 0, 0}, {1, nan, 0}, {0, 1, 0}}));
  std::vector<Vec3> star;
  for (int i = 0; i < 5; ++i)
    star.push_back(convert<Real>(Vec3d{sudar::cos(i * 0.8 * pi), sudar::sin(i * 0.8 * pi), 0}));
  EXPECT_TRUE(refused(star));
}

TEST(MakeGeometry, RebuildsFromPlainData) {
  std::vector<Shape> shapes{sphere(1), capsule(1, 2), half_space()};
  for (const Named& n : polyhedra()) shapes.push_back(n.shape);
  for (const Shape& s : shapes) {
    const Geometry& g = s.geometry();
    Geometry plain;
    plain.kind = g.kind;
    plain.radius = g.radius;
    plain.half_length = g.half_length;
    plain.hull.vertices = g.hull.vertices;
    plain.hull.loops = g.hull.loops;
    for (const Polyhedron::Face& f : g.hull.faces) plain.hull.faces.push_back({{}, 0, f.first, f.count});
    const std::shared_ptr<const Geometry> again = make_geometry(std::move(plain));
    EXPECT_TRUE(Shape(again) == s);
    EXPECT_EQ(again->hash, g.hash);
    EXPECT_EQ(again->bounding_radius, g.bounding_radius);
    EXPECT_EQ(again->mass.inertia, g.mass.inertia);
    EXPECT_EQ(again->hull.interior, g.hull.interior);
    ASSERT_EQ(again->hull.edges.size(), g.hull.edges.size());
    for (std::size_t f = 0; f < g.hull.faces.size(); ++f) {
      EXPECT_EQ(again->hull.faces[f].normal, g.hull.faces[f].normal);
      EXPECT_EQ(again->hull.faces[f].offset, g.hull.faces[f].offset);
    }
  }
}

TEST(MakeGeometry, EqualByContent) {
  EXPECT_TRUE(box({1, 2, 3}) == box({1, 2, 3}));
  EXPECT_EQ(box({1, 2, 3}).geometry().hash, box({1, 2, 3}).geometry().hash);
  EXPECT_FALSE(box({1, 2, 3}) == box({1, 3, 2}));
  EXPECT_FALSE(sphere(1) == sphere(2));
  EXPECT_FALSE(sphere(1) == Shape());
  EXPECT_TRUE(Shape() == Shape());
  const Vec3 plus[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
             minus[] = {{Real(-0.0), 0, 0}, {1, 0, Real(-0.0)}, {0, 1, 0}, {0, 0, 1}};
  EXPECT_EQ(hull(plus).geometry().hash, hull(minus).geometry().hash);  // −0 is 0
}

TEST(MakeGeometry, RefusesBrokenData) {
  const Shape cube = box({1, 1, 1});
  const auto refused = [&](const std::function<void(Geometry&)>& breaking) {
    Geometry g = cube.geometry();
    breaking(g);
    try {
      make_geometry(std::move(g));
      return false;
    } catch (const Error&) { return true; }
  };
  EXPECT_FALSE(refused([](Geometry&) {}));
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.faces.pop_back(); }));                      // a side is missing
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.loops[3] = 77; }));                         // no such vertex
  EXPECT_TRUE(refused([](Geometry& g) { std::swap(g.hull.loops[0], g.hull.loops[2]); }));  // a face turned round
  EXPECT_TRUE(refused([](Geometry& g) { std::swap(g.hull.loops[0], g.hull.loops[1]); }));  // a bow tie
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.faces[2].count = 3; }));
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.vertices.push_back({}); }));  // unused
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.vertices[0].x = 5; }));       // bent
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.vertices[0].x = std::numeric_limits<Real>::quiet_NaN(); }));
  EXPECT_TRUE(refused([](Geometry& g) {
    for (Vec3& v : g.hull.vertices) v.x = -v.x;
  }));  // inside out
  EXPECT_TRUE(refused([](Geometry& g) { g.hull.vertices.clear(); }));
  EXPECT_TRUE(refused([](Geometry& g) { g.kind = ShapeKind(int(ShapeKind::mesh) + 1); }));
  EXPECT_TRUE(refused([](Geometry& g) { g.kind = ShapeKind::sphere; }));  // radius 0
  EXPECT_TRUE(refused([](Geometry& g) { g.kind = ShapeKind::mesh; }));    // faces of four corners
}

TEST(Bounds, AreTheSmallestBox) {
  Random random;
  std::vector<Shape> shapes{sphere(1), capsule(Real(0.5), 2), hollow_sphere(2)};
  for (const Named& n : polyhedra()) shapes.push_back(n.shape);
  for (const Shape& s : shapes) {
    const double near = 1e-5 * double(s.bounding_radius());
    for (int i = 0; i < 20; ++i) {
      const Pose pose{{random.between(-50, 50), random.between(-50, 50), random.between(-50, 50)},
                      convert<Real>(random.rotation())};
      const Real margin = Real(0.25);
      const Box b = bounds(s.geometry(), pose, margin);
      for (int axis = 0; axis < 3; ++axis) {
        double low = 1e30, high = -1e30;
        const auto reach = [&](const Vec3& point, Real radius) {
          low = std::min(low, pose.point(point)[axis] - double(radius));
          high = std::max(high, pose.point(point)[axis] + double(radius));
        };
        for (const Vec3& v : s.vertices()) reach(v, 0);
        if (s.radius() > 0) reach({0, s.half_length(), 0}, s.radius()), reach({0, -s.half_length(), 0}, s.radius());
        EXPECT_NEAR(b.low[axis], low - 0.25, near);
        EXPECT_NEAR(b.high[axis], high + 0.25, near);
      }
    }
  }
  // Curved shapes: by their support functions.
  for (const Shape& s : {cylinder(1, 3), cylinder(2, Real(0.1)), cone(1, 2), ellipsoid({1, 2, 3}), hollow_cylinder(1, 4)}) {
    for (int i = 0; i < 50; ++i) {
      const Pose pose{{random.between(-50, 50), 0, 7}, convert<Real>(random.rotation())};
      const Box b = bounds(s.geometry(), pose, 0);
      for (int axis = 0; axis < 6; ++axis) {
        Vec3 d;
        d[axis % 3] = axis < 3 ? Real(1) : Real(-1);
        const Vec3d u = convert<double>(rotate_back(pose.q, d));
        const double h = s.half_length(), across = s.radius() * std::hypot(u.x, u.z);
        const double reach = s.kind() == ShapeKind::ellipsoid ? length(scale(convert<double>(s.radii()), u))
                             : s.kind() == ShapeKind::cone    ? std::max(1.5 * h * u.y, across - 0.5 * h * u.y)
                                                              : across + h * std::abs(u.y);
        const double got = axis < 3 ? b.high[axis] - pose.p[axis] : pose.p[axis - 3] - b.low[axis - 3];
        EXPECT_NEAR(got, reach, 1e-5);
      }
    }
  }
  const Box all = bounds(half_space().geometry(), {}, 1);
  EXPECT_TRUE(contains(all, Box{{-1e300, -1e300, -1e300}, {1e300, 1e300, 1e300}}));
}

}
