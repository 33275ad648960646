#include "view/marks.h"

#include <cmath>

#include "view/palette.h"

namespace sudar::view {

namespace {

// Radius of a dot at this place, so that it is seen equally large everywhere.
float dot_radius(const Vec3f& at) { return 0.0045f * length(at); }

Vec3f force_colour(ForceMark::Kind kind) {
  switch (kind) {
    case ForceMark::Kind::weight:
      return linear_colour(0x2f6fe0);
    case ForceMark::Kind::stick:
      return linear_colour(0x2fbf4a);
    case ForceMark::Kind::slip:
      return linear_colour(0xe0352b);
    case ForceMark::Kind::joint:
      break;
  }
  return linear_colour(0xf2c230);
}

}

void Marks::add_dot(Copies& copies, const Vec3f& at, float radius, const Vec3f& colour) const {
  copies[dot_].push_back({.position = at, .turn = {0, 0, 0, 1}, .scale = Vec3f{1, 1, 1} * radius, .colour = colour});
}

void Marks::add_stick(Copies& copies, const Vec3f& from, const Vec3f& to, float radius, const Vec3f& colour) const {
  const float reach = length(to - from);
  if (reach < 1e-6f) return;
  copies[stick_].push_back(
      {.position = from, .turn = turn_y_to((to - from) / reach), .scale = {radius, reach, radius}, .colour = colour});
}

void Marks::add_arrow(Copies& copies, const Vec3f& from, const Vec3f& to, float radius, const Vec3f& colour) const {
  const float reach = length(to - from);
  if (reach < 1e-6f) return;
  const Vec3f direction = (to - from) / reach, neck = to - direction * min(5 * radius, reach);
  add_stick(copies, from, neck, radius, colour);
  copies[cone_].push_back({.position = neck,
                           .turn = turn_y_to(direction),
                           .scale = {2.4f * radius, length(to - neck), 2.4f * radius},
                           .colour = colour});
}

// The axis; of a turn the sector from limit to limit and a hand that shows the angle; of a way the track and a dot.
void Marks::add_freedom(Copies& copies, const JointMark& j, const Pos& eye) const {
  if (j.axis == Vec3f{}) return;
  const Vec3f colour = linear_colour(0x3fb7e8), limit = linear_colour(0xf07c2a);
  const Vec3f at = relative(j.anchor_a, eye);
  const float r = dot_radius(at), size = max(j.size, 12 * r);
  const auto arrow = [&](const Vec3f& from, const Vec3f& to) { add_arrow(copies, from, to, 0.35f * r, colour); };
  arrow(at - j.axis * (0.8f * size), at + j.axis * (0.8f * size));
  if (!j.freedom) return;
  const FreedomMark& f = *j.freedom;
  const auto finite = [](float x) { return std::isfinite(x); };
  if (!f.turns) {
    const Vec3f low = at + f.axis * (finite(f.low) ? f.low : f.value - 2 * size);
    const Vec3f high = at + f.axis * (finite(f.high) ? f.high : f.value + 2 * size);
    add_stick(copies, low, high, 0.3f * r, limit);
    if (finite(f.low)) add_dot(copies, low, 1.3f * r, limit);
    if (finite(f.high)) add_dot(copies, high, 1.3f * r, limit);
    return;
  }
  const float radius = 0.6f * size;
  const auto rim = [&](float angle) {
    return at + (f.zero * std::cos(angle) + cross(f.axis, f.zero) * std::sin(angle)) * radius;
  };
  arrow(at, rim(f.value));
  for (const float end : {f.low, f.high}) {
    if (finite(end)) add_stick(copies, at, rim(end), 0.3f * r, limit);
  }
  if (!finite(f.low) || !finite(f.high)) return;
  constexpr int pieces = 24;
  const float range = min(f.high - f.low, 2 * float(pi));
  for (int i = 0; i < pieces; ++i) {
    const auto angle = [&](int n) { return f.low + range * float(n) / pieces; };
    add_stick(copies, rim(angle(i)), rim(angle(i + 1)), 0.3f * r, limit);
  }
}

void Marks::add_forces(Copies& copies, const Scene& scene, const Pos& eye) const {
  for (const ForceMark& f : scene.forces) {
    const Vec3f at = relative(f.at, eye);
    add_arrow(copies, at, at + f.force * scene.metres_per_newton, 0.55f * dot_radius(at), force_colour(f.kind));
  }
}

void Marks::place(const Scene& scene, const Pos& eye, const Style& style) {
  const Vec3f stick = force_colour(ForceMark::Kind::stick), slip = force_colour(ForceMark::Kind::slip),
              joint = force_colour(ForceMark::Kind::joint);
  Copies copies(3);
  if (style.contacts) {
    for (const ContactMark& c : scene.contacts) {
      const Vec3f at = relative(c.at, eye), colour = c.slipping ? slip : stick;
      const float r = dot_radius(at);
      add_dot(copies, at, r, colour);
      add_arrow(copies, at, at + c.normal * (9 * r), 0.3f * r, colour);
    }
  }
  if (style.joints) {
    for (const JointMark& j : scene.joints) {
      const Vec3f a = relative(j.anchor_a, eye), b = relative(j.anchor_b, eye);
      const float r = dot_radius(a);
      add_stick(copies, relative(j.center_a, eye), a, 0.3f * r, joint);
      add_stick(copies, a, b, 0.3f * r, slip);  // a gap, where there is one; a bar's length
      add_stick(copies, relative(j.center_b, eye), b, 0.3f * r, joint);
      add_dot(copies, a, r, joint);
      add_dot(copies, b, r, joint);
      add_freedom(copies, j, eye);
    }
  }
  if (style.forces) add_forces(copies, scene, eye);
  if (style.axes) {
    const Vec3f colours[] = {slip, stick, linear_colour(0x2f6fe0)};
    for (const Instance& i : scene.instances) {
      const Shape& shape = scene.shapes[i.shape];
      if (shape.kind() == ShapeKind::half_space) continue;
      const Vec3f at = relative(i.pose.p, eye);
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 direction;
        direction[axis] = Real(1.2) * shape.bounding_radius();
        add_arrow(copies, at, at + to_float(rotate(i.pose.q, direction)), 0.3f * dot_radius(at), colours[axis]);
      }
    }
  }
  instances_.place(copies);
}

}
