#include "view/marks.h"

#include "view/palette.h"

namespace sudar::view {

namespace {

// Radius of a dot at this place, so that it is seen equally large everywhere.
float dot_radius(const Vec3f& at) { return 0.0045f * length(at); }

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

void Marks::place(const Scene& scene, const Pos& eye, const Style& style) {
  const Vec3f stick = linear_colour(0x2fbf4a), slip = linear_colour(0xe0352b), joint = linear_colour(0xf2c230);
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
    }
  }
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
