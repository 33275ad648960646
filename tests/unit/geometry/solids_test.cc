// The closed forms of solids.h against integrals taken here, and against the 23 numbers of V38 that are not
// polyhedra's.
#include <sudar/solids.h>

#include <gtest/gtest.h>

#include <functional>

namespace sudar {
namespace {

using Profile = std::function<double(double)>;  // squared radius at height y

// ∫ g by Gauss's five points on many pieces, which crowd towards both ends, where a profile may be steep.
double integral(const std::function<double(double)>& g, double low, double high) {
  constexpr double at[] = {0, 0.538469310105683, -0.538469310105683, 0.906179845938664, -0.906179845938664};
  constexpr double weight[] = {0.568888888888889, 0.478628670499366, 0.478628670499366, 0.236926885056189,
                               0.236926885056189};
  constexpr int pieces = 400;
  const auto place = [&](int i) { return low + (high - low) * (1 - std::cos(pi * i / pieces)) / 2; };
  double sum = 0;
  for (int i = 0; i < pieces; ++i) {
    const double from = place(i), to = place(i + 1);
    for (int k = 0; k < 5; ++k) sum += weight[k] * g((from + to) / 2 + at[k] * (to - from) / 2) * (to - from) / 2;
  }
  return sum;
}

// Of rings between two profiles.
MassProperties integrated(
    double low, double high, const Profile& outer, const Profile& inner = [](double) { return 0; }) {
  const auto area = [&](double y) { return pi * (outer(y) - inner(y)); };
  MassProperties m;
  m.volume = integral(area, low, high);
  m.center.y = integral([&](double y) { return y * area(y); }, low, high) / m.volume;
  const double along =
      integral([&](double y) { return pi / 2 * (outer(y) * outer(y) - inner(y) * inner(y)); }, low, high);
  const double across = along / 2 + integral([&](double y) { return square(y - m.center.y) * area(y); }, low, high);
  m.inertia = Mat3d::diagonal({across, along, across});
  return m;
}

void expect_same(const MassProperties& got, const MassProperties& want, double tolerance = 1e-9) {
  EXPECT_NEAR(got.volume, want.volume, tolerance * want.volume);
  EXPECT_NEAR(got.center.x, 0, 1e-15);
  EXPECT_NEAR(got.center.y, want.center.y, tolerance);
  EXPECT_NEAR(got.center.z, 0, 1e-15);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(got.inertia[i][j], want.inertia[i][j], tolerance * trace(want.inertia));
  }
}

struct Named {
  const char* name;
  MassProperties got, integral;
  double volume, center, along, across;  // V38
};

Profile constant(double r) {
  return [=](double) { return r * r; };
}
Profile ball(double r, double center = 0) {
  return [=](double y) { return std::max(0.0, r * r - square(y - center)); };
}
Profile line(double bottom, double top, double low, double high) {
  return [=](double y) { return square(bottom + (top - bottom) * (y - low) / (high - low)); };
}
Profile tapered(double bottom, double top, double length) {
  const double sine = (bottom - top) / length, cosine = std::sqrt(1 - sine * sine), half = length / 2;
  const double low = -half + bottom * sine, high = half + top * sine;
  return [=](double y) {
    if (y < low) return ball(bottom, -half)(y);
    if (y > high) return ball(top, half)(y);
    return line(bottom * cosine, top * cosine, low, high)(y);
  };
}

std::vector<Named> solids() {
  using namespace solid;
  const auto torus_out = [](double y) { return square(1 + std::sqrt(std::max(0.0, 0.0625 - y * y))); };
  const auto torus_in = [](double y) { return square(1 - std::sqrt(std::max(0.0, 0.0625 - y * y))); };
  return {
      {"sphere", mass_of(Sphere{.5}), integrated(-.5, .5, ball(.5)), .523598775598, 0, .0523598775598, .0523598775598},
      {"thick shell", mass_of(ThickShell{.5, .3}), integrated(-.5, .5, ball(.5), ball(.3)), .410501440069, 0,
       .0482883734808, .0482883734808},
      {"cylinder", mass_of(Cylinder{.5, 2}), integrated(-1, 1, constant(.5)), 1.57079632679, 0, .196349540849,
       .621773546023},
      {"tube", mass_of(Tube{.5, .3, 2}), integrated(-1, 1, constant(.5), constant(.3)), 1.00530964915, 0, .170902640355,
       .420554536561},
      {"cone", mass_of(Cone{.5, 2}), integrated(0, 2, line(.5, 0, 0, 2)), .523598775598, .5, .0392699081699,
       .0981747704247},
      {"frustum", mass_of(Frustum{.5, .2, 2}), integrated(0, 2, line(.5, .2, 0, 2)), .816814089933, .730769230769,
       .064779640517, .258020615712},
      {"capsule", mass_of(Capsule{.5, 1.2}), integrated(-1.1, 1.1, tapered(.5, .5, 1.2)), 1.46607657168, 0,
       .170169602069, .530667359069},
      {"hemisphere", mass_of(Hemisphere{.5}), integrated(0, .5, ball(.5)), .261799387799, .1875, .0261799387799,
       .0169760540526},
      {"spheroid", mass_of(Ellipsoid{{.5, .8, .5}}),
       integrated(-.8, .8, [](double y) { return .25 * (1 - square(y / .8)); }), .837758040957, 0, .0837758040957,
       .14912093129},
      {"torus", mass_of(Torus{1, .25}), integrated(-.25, .25, torus_out, torus_in), 1.23370055014, 0, 1.29153026342,
       .665041702808},
      {"paraboloid", mass_of(Paraboloid{.5, 2}), integrated(0, 2, [](double y) { return .25 * y / 2; }), .785398163397,
       1.33333333333, .0654498469498, .207257848674},
      {"cap", mass_of(Cap{.5, .4}), integrated(.1, .5, ball(.5)), .184306769011, .245454545455, .0166211195326,
       .01004091092},
      {"tapered capsule", mass_of(TaperedCapsule{.389, .25, .5498}),
       integrated(-.5498 / 2 - .389, .5498 / 2 + .25, tapered(.389, .25, .5498)), .346555568159, -.135537701818,
       .0193816849834, .0356649155773},
  };
}

TEST(Solids, AgreeWithTheirIntegralsAndV38) {
  for (const Named& s : solids()) {
    SCOPED_TRACE(s.name);
    expect_same(s.got, s.integral, 1e-7);  // the pieces do not end where a tapered capsule's parts meet
    expect_same(s.got, {s.volume, {0, s.center, 0}, Mat3d::diagonal({s.across, s.along, s.across})}, 1e-10);
  }
}

TEST(Solids, LimitsMeet) {
  using namespace solid;
  expect_same(mass_of(Cap{.7, 1.4}), mass_of(Sphere{.7}), 1e-14);
  expect_same(mass_of(Cap{.7, .7}), mass_of(Hemisphere{.7}), 1e-14);
  expect_same(
      mass_of(Frustum{.7, .7, 2}),
      [] {
        MassProperties m = mass_of(Cylinder{.7, 2});
        m.center.y = 1;
        return m;
      }(),
      1e-14);
  expect_same(mass_of(Frustum{.7, 1e-9, 2}), mass_of(Cone{.7, 2}), 1e-8);
  expect_same(mass_of(TaperedCapsule{.5, .5, 1.2}), mass_of(Capsule{.5, 1.2}), 1e-14);
  expect_same(mass_of(Ellipsoid{{.6, .6, .6}}), mass_of(Sphere{.6}), 1e-14);
  const Vec3d edges{1, 2, 3};
  const MassProperties b = mass_of(solid::Box{edges});
  EXPECT_EQ(b.volume, 6);
  EXPECT_NEAR(length(Vec3d{b.inertia[0][0], b.inertia[1][1], b.inertia[2][2]} - Vec3d{6.5, 5, 2.5}), 0, 1e-14);
  // A thin cap, in which the formulas about the centre of the sphere would cancel: nearly a paraboloid.
  const MassProperties thin = mass_of(Cap{1, 1e-6});
  EXPECT_NEAR(thin.volume, pi * 1e-12, 1e-6 * thin.volume);
  EXPECT_NEAR(1 - thin.center.y, 2e-6 / 3, 1e-12);
}

TEST(Solids, AShapeHasTheMassOfItsSolid) {
  const double r = Real(0.3), h = Real(0.8);
  expect_same(cylinder(Real(r), Real(h)).mass_properties(), mass_of(solid::Cylinder{r, h}), 1e-14);
  MassProperties lifted = mass_of(solid::Cone{r, h});
  lifted.center = {};
  expect_same(cone(Real(r), Real(h)).mass_properties(), lifted, 1e-14);
  const MassProperties e = ellipsoid({1, 2, 3}).mass_properties(), want = mass_of(solid::Ellipsoid{{1, 2, 3}});
  EXPECT_EQ(e.volume, want.volume);
  EXPECT_EQ(e.inertia, want.inertia);
}

TEST(Solids, InertiaOfAMass) {
  const Mat3 hoop = inertia_of(mass_of(solid::Tube{.5, .4999, .1}), 2);
  EXPECT_NEAR(hoop[1][1], 2 * .25, 1e-3);
  EXPECT_NEAR(hoop[0][0], 2 * (.125 + .01 / 12), 1e-3);
}

TEST(Solids, BadSizesAreNamed) {
  using namespace solid;
  const auto field = [](auto s) {
    try {
      mass_of(s);
      return std::string();
    } catch (const Error& e) { return e.field; }
  };
  EXPECT_EQ(field(Sphere{0}), "radius");
  EXPECT_EQ(field(ThickShell{.5, .5}), "outer");
  EXPECT_EQ(field(Ellipsoid{{1, -1, 1}}), "radii.y");
  EXPECT_EQ(field(Tube{.5, .6, 1}), "outer");
  EXPECT_EQ(field(Cylinder{1, std::nan("")}), "height");
  EXPECT_EQ(field(TaperedCapsule{2, .5, 1}), "length");
  EXPECT_EQ(field(Torus{1, 2}), "ring");
  EXPECT_EQ(field(Cap{1, 3}), "height");
  EXPECT_EQ(field(Frustum{1, 0, 1}), "top");
  EXPECT_EQ(field(solid::Box{{1, 1, 0}}), "edges.z");
}

}
}
