// Degrees of freedom as joints. One is a hinge, a slider or a ball. Several between the same two links stand in a file
// for links between them that have no mass; such a link is here what mechanics makes of it: the conditions that it puts
// on the two bodies. Points of b in planes of a, and bars between points of both, say all that can be said of lines:
//   two hinges whose lines meet      a ball, and a bar that keeps the angle between the lines (a universal joint)
//   two hinges whose lines are skew  four bars, each from one of two points of one line to one of two of the other:
//   with
//                                    the lines they are a tetrahedron, which is rigid
//   two parallel hinges              three points of b stay in their plane, and a bar
//   three hinges that meet           a ball
//   slides and a hinge across them   three points of b stay in their plane; with one slide, also its line
//   a slide and a hinge along it     two points of b stay on the line
#include <algorithm>

#include "io/articulation.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr double lever = 0.1;      // m: between the points that stand for a line or a plane
constexpr double meeting = 1e-7;   // m: lines that come so near to each other meet
constexpr double parallel = 1e-7;  // sine of the angle

Pos position(const Vec3d& p) { return {p.x, p.y, p.z}; }

bool along(const Vec3d& a, const Vec3d& b) { return length(cross(a, b)) < parallel; }
bool across(const Vec3d& a, const Vec3d& b) { return abs(dot(a, b)) < parallel; }

// Where two lines that are not parallel are nearest to each other: on either one.
std::pair<Vec3d, Vec3d> nearest(const Degree& a, const Degree& b) {
  const Vec3d n = cross(a.axis, b.axis), apart = b.at - a.at;
  const double n2 = length_squared(n);
  return {a.at + a.axis * (dot(cross(apart, b.axis), n) / n2), b.at + b.axis * (dot(cross(apart, a.axis), n) / n2)};
}

bool on_line(const Vec3d& point, const Degree& d) { return length(cross(point - d.at, d.axis)) < meeting; }

class Connection {
 public:
  Connection(Model& model, Remarks& remarks, Body a, Body b, std::span<const Degree> degrees)
      : model_(model), remarks_(remarks), a_(a), b_(b), degrees_(degrees) {}

  void make() {
    if (degrees_.size() == 1) {
      one(degrees_[0]);
      return;
    }
    for (const Degree& d : degrees_) {
      if (d.range || d.stiffness > 0 || d.damping > 0 || d.friction > 0 || d.armature > 0)
        remarks_.warn(d.from,
                      "is one of several joints between two links: its range, spring, damping, friction and armature "
                      "are left out");
    }
    if (!several()) {
      remarks_.warn(degrees_[0].from,
                    "begins a chain of joints without mass between them, which cannot be made: the two links "
                    "move freely against each other");
    }
  }

 private:
  void add(JointDef def) { model_.joints.push_back({std::move(def), degrees_[0].from, degrees_[0].name}); }
  void ball(const Vec3d& at) { add(Ball{.a = a_, .b = b_, .at = position(at)}); }
  void bar(const Vec3d& on_a, const Vec3d& on_b) {
    add(Bar{.a = a_, .b = b_, .at_a = position(on_a), .at_b = position(on_b)});
  }
  // A point of b stays in a plane of a, or the other way round.
  void plane(const Vec3d& at, const Vec3d& normal, bool of_a = true) {
    add(sudar::Plane{.a = of_a ? a_ : b_, .b = of_a ? b_ : a_, .at = position(at), .normal = convert<Real>(normal)});
  }
  // b moves and turns in the plane alone.
  void planar(const Vec3d& at, const Vec3d& normal) {
    const Vec3d x = any_perpendicular(normal), y = cross(normal, x);
    for (const auto& [i, k] : {std::pair{1.0, 0.0}, {-0.5, 0.75}, {-0.5, -0.75}})
      plane(at + (x * i + y * k) * lever, normal);
  }
  // A point of b stays on the line.
  void line(const Vec3d& at, const Vec3d& direction) {
    const Vec3d x = any_perpendicular(direction);
    plane(at, x), plane(at, cross(direction, x));
  }

  void one(const Degree& d) {
    if (d.kind == Freedom::ball) {
      if (d.range || d.stiffness > 0 || d.damping > 0 || d.friction > 0 || d.armature > 0)
        remarks_.warn(d.from, "is a ball joint: its range, spring, damping, friction and armature are left out");
      ball(d.at);
      return;
    }
    const auto make = [&]<class Def>(Def def) {
      def.a = a_, def.b = b_, def.at = position(d.at), def.axis = convert<Real>(d.axis);
      if (d.range) def.limit = {Real(d.range->first), Real(d.range->second)};
      def.drive = drive(d);
      add(std::move(def));
    };
    if (d.kind == Freedom::hinge)
      make(Hinge{});
    else
      make(Slider{});
  }

  Drive drive(const Degree& d) {
    if (d.armature > 0) remarks_.warn(d.from, "the armature, inertia of a rotor, is left out");
    if (d.stiffness > 0 || d.damping > 0) {
      if (d.friction > 0) remarks_.warn(d.from, "the friction is left out beside a spring or damping");
      return {.mode = DriveMode::spring,
              .target = Real(d.rest),
              .force = Real(d.force),
              .stiffness = Real(d.stiffness),
              .damping = Real(d.damping)};
    }
    if (d.friction > 0) return {.mode = DriveMode::speed, .force = Real(d.friction)};
    return {};
  }

  // False: such a chain is none of those above.
  bool several() {
    std::vector<const Degree*> hinges, slides;  // from the parent outwards
    for (const Degree& d : degrees_) {
      if (d.kind == Freedom::ball) return false;
      (d.kind == Freedom::hinge ? hinges : slides).push_back(&d);
    }
    if (slides.empty() && hinges.size() == 2) return two_hinges(*hinges[0], *hinges[1]);
    if (slides.empty() && hinges.size() == 3) return three_hinges(*hinges[0], *hinges[1], *hinges[2]);
    if (hinges.size() == 1 && slides.size() == 1) return slide_and_hinge(*slides[0], *hinges[0]);
    if (hinges.size() == 1 && slides.size() == 2) return planar(*slides[0], *slides[1], *hinges[0]);
    return false;
  }

  bool two_hinges(const Degree& p, const Degree& q) {
    if (along(p.axis, q.axis)) {
      if (on_line(p.at, q)) return false;  // one line: two hinges are one, and the coordinates nobody's
      planar(q.at, q.axis);
      const Vec3d foot = p.at + p.axis * dot(q.at - p.at, p.axis);
      bar(foot, q.at);
      return true;
    }
    const auto [on_p, on_q] = nearest(p, q);
    const double apart = length(on_q - on_p);
    if (apart < meeting) {
      ball(on_p);
      bar(on_p + p.axis * lever, on_p + q.axis * lever);
      return true;
    }
    for (const double i : {-apart, apart}) {
      for (const double k : {-apart, apart}) bar(on_p + p.axis * i, on_q + q.axis * k);
    }
    return true;
  }

  bool three_hinges(const Degree& p, const Degree& q, const Degree& r) {
    if (along(p.axis, q.axis) || abs(dot(p.axis, cross(q.axis, r.axis))) < 1e-3) return false;
    const auto [at, also] = nearest(p, q);
    if (length(also - at) > meeting || !on_line(at, r)) return false;
    ball(at);
    return true;
  }

  bool slide_and_hinge(const Degree& slide, const Degree& hinge) {
    if (along(slide.axis, hinge.axis)) {
      line(hinge.at, hinge.axis), line(hinge.at + hinge.axis * lever, hinge.axis);
      return true;
    }
    if (!across(slide.axis, hinge.axis)) return false;
    planar(hinge.at, hinge.axis);
    const bool slides_first = &slide < &hinge;  // both are of degrees_
    plane(hinge.at, cross(hinge.axis, slide.axis), slides_first);
    return true;
  }

  // Two slides across a hinge.
  bool planar(const Degree& slide, const Degree& other, const Degree& hinge) {
    if (along(slide.axis, other.axis) || !across(slide.axis, hinge.axis) || !across(other.axis, hinge.axis))
      return false;
    planar(hinge.at, hinge.axis);
    return true;
  }

  Model& model_;
  Remarks& remarks_;
  Body a_, b_;
  std::span<const Degree> degrees_;
};

}

void connect(Model& model, Remarks& remarks, Body a, Body b, std::span<const Degree> degrees) {
  Connection(model, remarks, a, b, degrees).make();
}

}
