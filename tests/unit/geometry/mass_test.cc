// Mass properties against closed forms and exact sums.
#include "geometry/geometry.h"
#include "geometry/hull.h"
#include "geometry/principal.h"

#include "unit/random.h"

#include <gtest/gtest.h>

#include <cstdint>

using namespace sudar;
using sudar_test::Random;

namespace {

// Relative errors allowed: of what is computed in double, and of shapes whose corners were rounded to Real.
constexpr double exact = 1e-13;
const double rounded = sizeof(Real) == 4 ? 1e-6 : 1e-13;

struct Mesh {
  std::vector<Vec3d> vertices;
  std::vector<std::uint32_t> triangles;
};

// The box low … high, outward.
Mesh box_mesh(const Vec3d& low, const Vec3d& high) {
  Mesh m;
  for (int i = 0; i < 8; ++i)
    m.vertices.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  m.triangles = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                 2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  return m;
}

void append(Mesh& to, Mesh other, bool inside_out) {
  const std::uint32_t first = std::uint32_t(to.vertices.size());
  for (std::size_t i = 0; inside_out && i < other.triangles.size(); i += 3) {
    std::swap(other.triangles[i], other.triangles[i + 1]);
  }
  to.vertices.insert(to.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const std::uint32_t v : other.triangles) to.triangles.push_back(first + v);
}

MassProperties mass_of(const Mesh& m) { return mass_properties(m.vertices, m.triangles); }

void expect_near(const Mat3d& a, const Mat3d& b, double relative) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(a[i][j], b[i][j], relative * std::abs(trace(b))) << i << j;
  }
}

// Principal moments in the order of the axes; their products vanish.
void expect_mass(const Shape& shape, double volume, const Vec3d& center, const Vec3d& moments, double relative) {
  const MassProperties m = shape.mass_properties();
  EXPECT_NEAR(m.volume, volume, relative * volume);
  EXPECT_LT(length(m.center - center), 4 * relative * double(shape.bounding_radius()));
  expect_near(m.inertia, Mat3d::diagonal(moments), 2 * relative);
}

TEST(Mass, ThesisMistakeVolumeByFour) {
  // The thesis's text gives a tetrahedron the volume a·(b×c)/4; a unit cube would weigh 1.5.
  const MassProperties m = mass_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  EXPECT_NEAR(m.volume, 1, exact);
  EXPECT_NEAR(m.inertia[0][0], 1.0 / 6, exact);
  EXPECT_LT(length(m.center - Vec3d{0.5, 0.5, 0.5}), exact);
}

// V37: hulls of pseudo-random integer points. Six times the volume and all moments about the origin are then integers.
TEST(Mass, V37RandomIntegerHulls) {
  struct Case {
    std::uint32_t seed;
    int points;
    std::size_t vertices;
    std::int64_t six_volumes;
    Vec3d center;              // as published, 12 digits
    Vec3d diagonal, products;  // Ixx Iyy Izz, Ixy Iyz Izx
  };
  const Case cases[] = {{1,
                         12,
                         11,
                         1663622,
                         {11.1399998016, 4.25590308375, -2.16641084934},
                         {208379208.989, 193347757.072, 214804548.784},
                         {13443607.2509, 26934777.9958, -19056518.1767}},
                        {2,
                         24,
                         15,
                         2329831,
                         {-3.56701097633, 2.84140083551, -0.142482437567},
                         {369109314.612, 384286329.849, 332752417.151},
                         {10828883.4751, 67253903.1714, 26360109.819}},
                        {3,
                         60,
                         25,
                         3348240,
                         {-1.7650258046, 2.19393636657, -6.65237356044},
                         {580042434.217, 685562545.494, 602890384.207},
                         {-16685035.3189, -9029360.29763, -25711209.0331}}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.seed);
    std::uint32_t x = c.seed;
    const auto next = [&] { return Real(int(((x = x * 1664525u + 1013904223u) >> 16) % 101) - 50); };
    std::vector<Vec3> points;
    for (int i = 0; i < c.points; ++i) {
      const Real px = next(), py = next();
      points.push_back({px, py, next()});
    }
    const Shape shape = hull(points);
    EXPECT_EQ(shape.vertices().size(), c.vertices);
    const MassProperties m = shape.mass_properties();

    // Exact, in integers about the origin: det, det (a+b+c), det (aaᵀ + bbᵀ + ccᵀ + ssᵀ).
    std::int64_t six_volumes = 0, first[3] = {}, second[3][3] = {};
    for (const std::vector<std::uint32_t>& face : shape.faces()) {
      for (std::size_t i = 2; i < face.size(); ++i) {
        std::int64_t v[4][3];
        const std::uint32_t corners[3] = {face[0], face[i - 1], face[i]};
        for (int k = 0; k < 3; ++k) {
          for (int j = 0; j < 3; ++j) v[j][k] = std::int64_t(shape.vertices()[corners[j]][k]);
          v[3][k] = v[0][k] + v[1][k] + v[2][k];
        }
        const auto& [a, b, d, s] = v;
        const std::int64_t det = a[0] * (b[1] * d[2] - b[2] * d[1]) + a[1] * (b[2] * d[0] - b[0] * d[2]) +
                                 a[2] * (b[0] * d[1] - b[1] * d[0]);
        six_volumes += det;
        for (int p = 0; p < 3; ++p) {
          first[p] += det * s[p];
          for (int q = 0; q < 3; ++q) second[p][q] += det * (a[p] * a[q] + b[p] * b[q] + d[p] * d[q] + s[p] * s[q]);
        }
      }
    }
    EXPECT_EQ(six_volumes, c.six_volumes);
    const long double volume = six_volumes / 6.0L;
    EXPECT_NEAR(m.volume, double(volume), exact * double(volume));
    Mat3d covariance;
    for (int p = 0; p < 3; ++p) {
      const long double center = first[p] / (4.0L * six_volumes);
      EXPECT_NEAR(m.center[p], double(center), exact * 50);
      EXPECT_NEAR(m.center[p], c.center[p], 1e-10);
      for (int q = 0; q < 3; ++q) {
        covariance[q][p] = double(second[p][q] / 120.0L - volume * center * (first[q] / (4.0L * six_volumes)));
      }
    }
    expect_near(m.inertia, Mat3d::identity() * trace(covariance) - covariance, exact);
    const double size = 1e-11 * trace(m.inertia);
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(m.inertia[i][i], c.diagonal[i], size);
      EXPECT_NEAR(std::abs(m.inertia[(i + 1) % 3][i]), std::abs(c.products[i]), size);
    }
  }
}

TEST(Mass, V38Solids) {
  const double phi = 1.61803398874989484820;
  expect_mass(sphere(0.5), 0.523598775598299, {}, {0.0523598775598299, 0.0523598775598299, 0.0523598775598299}, exact);
  expect_mass(box({1, 1, 1}), 1, {}, {1.0 / 6, 1.0 / 6, 1.0 / 6}, exact);
  expect_mass(box({1, 2, 3}), 6, {}, {6.5, 5, 2.5}, exact);
  const auto all = [](double i) { return Vec3d{i, i, i}; };
  expect_mass(tetrahedron(Real(2 * std::sqrt(2.0))), 8.0 / 3, {}, all(16.0 / 15), 2 * rounded);
  expect_mass(octahedron(Real(std::sqrt(2.0))), 4.0 / 3, {}, all(4.0 / 15), 2 * rounded);
  expect_mass(icosahedron(2), 10 * phi * phi * 2 / 3, {}, all(17.453559924999299 * 4 * phi * phi / 10), rounded);
  const double dodecahedron_volume = (15 + 7 * std::sqrt(5.0)) / 4 * std::pow(2 / phi, 3);
  expect_mass(dodecahedron(Real(2 / phi)), dodecahedron_volume, {},
              all(dodecahedron_volume * (95 + 39 * std::sqrt(5.0)) / 300 * std::pow(2 / phi, 2)), 2 * rounded);
  const double hexagon = 3 * std::sqrt(3.0);
  expect_mass(prism(6, 1, 2), hexagon, {}, {hexagon * 13 / 24, hexagon * 5 / 12, hexagon * 13 / 24}, rounded);
  const double triangle = 1.5 * std::sqrt(3.0);
  expect_mass(prism(3, 1, 2), triangle, {}, {triangle * 11 / 24, triangle / 4, triangle * 11 / 24}, rounded);
  const Real diagonal = Real(std::sqrt(2.0));  // base 2 × 2, height 2
  expect_mass(pyramid(4, diagonal, 2), 8.0 / 3, {}, {14.0 / 15, 16.0 / 15, 14.0 / 15}, 2 * rounded);
  // A wedge with legs 1, 1 and length 2.
  const MassProperties w = wedge({1, 1, 2}).mass_properties();
  EXPECT_NEAR(w.volume, 1, rounded);
  EXPECT_LT(length(w.center), rounded);
  Mat3d inertia = Mat3d::diagonal({7.0 / 18, 7.0 / 18, 1.0 / 9});
  inertia[0][1] = inertia[1][0] = 1.0 / 36;
  expect_near(w.inertia, inertia, rounded);
}

TEST(Mass, V38Capsule) {
  // The radius and length as rounded to Real.
  const double r = double(Real(0.5)), length = double(Real(1.2) / 2) * 2;
  const Shape shape = capsule(Real(0.5), Real(1.2));
  const double cylinder = pi * r * r * length, ball = 4 * pi * r * r * r / 3;
  const double across =
      cylinder * (length * length / 12 + r * r / 4) + ball * (0.4 * r * r + length * length / 4 + 3 * length * r / 8);
  const double along = cylinder * r * r / 2 + ball * 0.4 * r * r;
  expect_mass(shape, cylinder + ball, {}, {across, along, across}, exact);
  expect_mass(shape, 1.46607657168, {}, {0.530667359069, 0.170169602069, 0.530667359069}, std::max(rounded, 1e-11));
}

TEST(Mass, FineMeshesApproachTheSmoothBodies) {
  const MassProperties s = uv_sphere(0.5, 200, 100).mass_properties(), c = cylinder(0.5, 2, 200).mass_properties();
  const MassProperties k = cone(0.5, 2, 200).mass_properties();
  EXPECT_NEAR(s.volume, 0.523598775598, 1e-3);
  EXPECT_NEAR(s.inertia[1][1], 0.0523598775598, 1e-4);
  EXPECT_NEAR(c.inertia[1][1], 0.196349540849, 1e-3);
  EXPECT_NEAR(c.inertia[0][0], 0.621773546023, 1e-3);
  EXPECT_NEAR(k.inertia[1][1], 0.0392699081699, 1e-4);
  EXPECT_NEAR(k.inertia[0][0], 0.0981747704247, 1e-4);
}

// A box with a box-shaped hole: concave, with two surfaces; by difference.
TEST(Mass, ConcaveAndHollow) {
  const MassProperties outer = mass_of(box_mesh({-2, -2, -2}, {2, 2, 2})),
                       hole = mass_of(box_mesh({0, 0, 0}, {1, 1, 1}));
  Mesh m = box_mesh({-2, -2, -2}, {2, 2, 2});
  append(m, box_mesh({0, 0, 0}, {1, 1, 1}), true);
  const MassProperties hollow = mass_of(m);
  EXPECT_NEAR(hollow.volume, 63, 63 * exact);
  EXPECT_LT(length(hollow.center - Vec3d{-0.5, -0.5, -0.5} / 63), exact);
  // Parallel axes (Steiner): about the origin the inertias subtract.
  const auto about_origin = [](const MassProperties& p) {
    return p.inertia + (Mat3d::identity() * length_squared(p.center) - Mat3d::outer(p.center, p.center)) * p.volume;
  };
  expect_near(about_origin(hollow), about_origin(outer) - about_origin(hole), exact);
}

// An L: its notch is concave, and the origin lies outside.
TEST(Mass, ConcaveL) {
  const double x[6] = {0, 2, 2, 1, 1, 0}, y[6] = {0, 0, 1, 1, 2, 2};
  Mesh m;
  for (int i = 0; i < 12; ++i) m.vertices.push_back({x[i % 6] + 7, y[i % 6] - 9, i / 6 + 3.0});
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    m.triangles.insert(m.triangles.end(), {i, j, 6 + j, i, 6 + j, 6 + i});
  }
  for (const auto& t : {std::array<std::uint32_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    m.triangles.insert(m.triangles.end(), {t[0], t[2], t[1], 6 + t[0], 6 + t[1], 6 + t[2]});
  }
  const MassProperties l = mass_of(m);
  EXPECT_NEAR(l.volume, 3, exact);
  EXPECT_LT(length(l.center - Vec3d{7 + 5.0 / 6, -9 + 5.0 / 6, 3.5}), 1e-12);
  // Three unit squares around (5/6, 5/6): 3/12 each way plus Steiner 2 (1/3)² + (2/3)².
  EXPECT_NEAR(l.inertia[0][0], 3.0 / 12 + 3.0 / 12 + 6.0 / 9, 1e-12);
  EXPECT_NEAR(l.inertia[2][2], 2 * (3.0 / 12 + 6.0 / 9), 1e-12);
}

TEST(Mass, AnyOriginAnyTurn) {
  Random random;
  const Vec3d edges{1, 2, 3};
  for (int i = 0; i < 100; ++i) {
    const Quatd q = random.rotation();
    const Vec3d shift = random.in_cube(100);
    Mesh m = box_mesh(edges * -0.5, edges * 0.5);
    for (Vec3d& v : m.vertices) v = rotate(q, v) + shift;
    const MassProperties p = mass_of(m);
    EXPECT_NEAR(p.volume, 6, 1e-11);
    EXPECT_LT(length(p.center - shift), 1e-11);
    const Mat3d r = matrix(q);
    expect_near(p.inertia, r * Mat3d::diagonal({6.5, 5, 2.5}) * transpose(r), 1e-11);
  }
}

TEST(Mass, OpenSurfacesAreRefused) {
  const auto refused = [](const Mesh& m) {
    try {
      mass_of(m);
      return false;
    } catch (const Error& error) { return error.field == "triangles"; }
  };
  const Mesh closed = box_mesh({0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(refused(closed));
  Mesh open = closed;
  open.triangles.resize(33);
  EXPECT_TRUE(refused(open));
  Mesh turned = closed;  // one triangle the wrong way round
  std::swap(turned.triangles[0], turned.triangles[1]);
  EXPECT_TRUE(refused(turned));
  Mesh inside_out;
  append(inside_out, closed, true);
  EXPECT_TRUE(refused(inside_out));
  Mesh wrong = closed;
  wrong.triangles[5] = 8;
  EXPECT_TRUE(refused(wrong));
  EXPECT_TRUE(refused({}));
  Mesh torn = closed;
  torn.triangles.pop_back();
  EXPECT_TRUE(refused(torn));
}

TEST(PrincipalFrame, BoxesKeepTheirAxes) {
  for (const Shape& s : {box({1, 2, 3}), dodecahedron(1), prism(24, 6, 6), cone(1, 3), uv_sphere(2), capsule(1, 1)}) {
    const PrincipalFrame f = principal_frame(s.mass_properties());
    EXPECT_EQ(f.shape.q, Quat{});
    EXPECT_LT(double(length(f.shape.p)), 1e-6);
  }
}

TEST(PrincipalFrame, MakesTheInertiaDiagonal) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    std::vector<Vec3> points;
    for (int k = 0; k < 20; ++k) points.push_back(convert<Real>(scale(random.in_cube(), {1, 2, 3}) + Vec3d{5, 0, 1}));
    const MassProperties m = hull(points).mass_properties();
    const PrincipalFrame f = principal_frame(m);
    // The shape's frame in the body's takes the centre of mass to 0 and the tensor to a diagonal one.
    EXPECT_LT(double(length(f.shape.point(convert<Real>(m.center)))), 1e-5);
    const Mat3d turn = matrix(convert<double>(f.shape.q));
    expect_near(turn * m.inertia * transpose(turn), Mat3d::diagonal(f.moments), 2e-6);
    EXPECT_NEAR(f.moments.x + f.moments.y + f.moments.z, trace(m.inertia), 1e-12 * trace(m.inertia));
    EXPECT_NEAR(double(length_squared(f.shape.q)), 1, 1e-6);
  }
}

}
