// Many-sided hulls that are small against the margin within which contacts are made (10 mm) sank by the height of a row
// of vertices or more, gained energy and rocked for ever: all their vertices were candidates, and the outermost four
// were kept, not those that carry. On half spaces a 5 cm prism sank by 0.4 of its radius and gained 0.13 of its weight
// times its radius; on boxes only the corners of one face were ever seen.
#include "unit/worlds.h"

#include <string>
#include <vector>

using namespace sudar_test;

namespace {

struct Form {
  std::string name;
  Shape shape;
};

Shape frustum(int sides, Real bottom, Real top, Real height) {
  std::vector<Vec3> points;
  for (int i = 0; i < sides; ++i) {
    const Real angle = Real(2 * 3.14159265358979 * i / sides), x = sudar::cos(angle), z = sudar::sin(angle);
    points.push_back({bottom * x, -height / 2, bottom * z});
    points.push_back({top * x, height / 2, top * z});
  }
  return hull(points);
}

// Hulls of circumradius r or a little more, all wider than r/3.
std::vector<Form> forms(Real r) {
  std::vector<Form> all{{"dodecahedron", dodecahedron(r / Real(1.4))}, {"uv sphere", uv_sphere(r, 12, 8)}};
  for (const int sides : {8, 16, 64}) {
    const std::string n = std::to_string(sides);
    all.push_back({"prism " + n, prism(sides, r, r)});
    all.push_back({"long prism " + n, prism(sides, r / 3, 3 * r)});
    all.push_back({"cone " + n, cone(r, Real(1.5) * r, sides)});
    all.push_back({"frustum " + n, frustum(sides, r, Real(0.6) * r, r)});
  }
  return all;
}

enum class Floor { half_space, box, hull, heavy_box };
constexpr Floor floors[] = {Floor::half_space, Floor::box, Floor::hull, Floor::heavy_box};
const char* const floor_names[] = {"half space", "box", "hull", "dynamic box"};

enum class StartPose { lying, standing, askew, tilted };
constexpr StartPose poses[] = {StartPose::lying, StartPose::standing, StartPose::askew, StartPose::tilted};

Quat turn_of(StartPose pose) {
  switch (pose) {
    case StartPose::lying:
      return axis_angle(Vec3{0, 0, 1}, Real(1.5707963));
    case StartPose::askew:
      return axis_angle(normalize(Vec3{1, 2, 3}), Real(1.1));
    case StartPose::tilted:
      return axis_angle(normalize(Vec3{1, Real(0.1), Real(0.3)}), Real(0.06));
    case StartPose::standing:
      break;
  }
  return {0, 0, 0, 1};
}

struct Outcome {
  double depth = 0;    // of the deepest vertex at the end, of r
  double gained = 0;   // most energy above the least before it, of m g r
  double kinetic = 0;  // most in the last half second, of m g r
};

// Falls by half its radius and is watched for `seconds`; what is askew is also thrown and spun.
Outcome land(const Shape& shape, Real r, StartPose pose, Floor floor, int substeps, double seconds) {
  World w(steady(1.0 / 60, substeps));
  w.add(Gravity{});
  const Material m{Real(0.5), Real(0.5), 0};
  if (floor == Floor::half_space) {
    add_floor(w, 0, m);
  } else {
    if (floor == Floor::heavy_box) add_floor(w, -1, m);
    const bool many = floor == Floor::hull, heavy = floor == Floor::heavy_box;
    w.add({.shape = many ? prism(12, 2, 1) : box({4, 1, 4}),
           .at = {0, -0.5, 0},
           .density = 1000,
           .material = m,
           .motion = heavy ? Motion::dynamic : Motion::fixed});
  }
  const auto lowest = [&](const Pose& at) {
    double low = 1e9;
    for (const Vec3& v : shape.vertices()) low = std::min(low, at.p.y + double(rotate(at.q, v).y));
    return low;
  };
  const Quat turn = turn_of(pose);
  const Body body = w.add({.shape = shape,
                           .at = {0, 0.5 * double(r) - lowest({{}, turn}), 0},
                           .turn = turn,
                           .density = 1000,
                           .material = m});
  const Real fall = sqrt(Real(9.81) * r), spin = sqrt(Real(9.81) / r);
  if (pose == StartPose::askew) {
    w.set_velocity(body, {Real(0.3) * fall, 0, 0}, {Real(0.3) * spin, Real(0.2) * spin, Real(-0.5) * spin});
  }
  const double weight = 9.81 * 1000 * double(shape.mass_properties().volume), unit = weight * double(r);
  const auto energy = [&] { return (w[body].kinetic_energy() + weight * w[body].center().y) / unit; };
  Outcome out;
  double least = energy();
  const int steps = int(60 * seconds);
  for (int i = 0; i < steps; ++i) {
    w.step();
    out.gained = std::max(out.gained, energy() - least);
    least = std::min(least, energy());
    if (i > steps - 30) out.kinetic = std::max(out.kinetic, w[body].kinetic_energy() / unit);
  }
  out.depth = -lowest(w[body].pose()) / double(r);
  return out;
}

struct Family {
  Real r;  // m
  int substeps;
};

class ManySidedHull : public testing::TestWithParam<Family> {};

TEST_P(ManySidedHull, RestsOnItsLowestVerticesOnEveryFloor) {
  const auto [r, substeps] = GetParam();
  for (const Form& form : forms(r)) {
    for (const StartPose pose : poses) {
      for (const Floor floor : floors) {
        const Outcome out = land(form.shape, r, pose, floor, substeps, 2);
        const std::string which =
            form.name + ", pose " + std::to_string(int(pose)) + ", on a " + floor_names[int(floor)];
        EXPECT_LT(out.depth, 0.02) << which;
        EXPECT_LT(out.gained, 0.001) << which;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, ManySidedHull,
                         testing::Values(Family{Real(0.005), 16}, Family{Real(0.025), 4}, Family{Real(0.025), 16},
                                         Family{Real(0.25), 4}));

// Prisms rock about a side, and lose a part of their energy with each side that lands.
TEST(ManySidedHulls, StopRocking) {
  for (const int sides : {8, 12, 16, 24}) {
    for (const Real r : {Real(0.005), Real(0.025)}) {
      for (const Floor floor : floors) {
        const Outcome out = land(prism(sides, r, r), r, StartPose::askew, floor, 4, 4);
        EXPECT_LT(out.kinetic, 1e-6) << sides << " sides, radius " << r << " on a " << floor_names[int(floor)];
      }
    }
  }
}

}
