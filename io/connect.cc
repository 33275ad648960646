// Degrees of freedom as joints. One is a hinge, a slider or a ball. Several between the same two links stand in a file
// for links between them that have no mass; such a link is here what mechanics makes of it: the conditions that it puts
// on the two bodies. Points of b in planes of a, and bars between points of both, say all that can be said of lines:
//   two hinges whose lines meet      a ball, and a bar that keeps the angle between the lines (a universal joint)
//   two hinges whose lines are skew  four bars, each from one of two points of one line to one of two of the other:
//   with
//                                    the lines they are a tetrahedron, which is rigid
//   two parallel hinges              three points of b stay in their plane, and a bar
//   three hinges that meet           a ball
//   slides alone                     no turning; with two of them, a point of b in a plane
//   slides and a hinge across them   three points of b stay in their plane; with one slide, also its line
//   a slide and a hinge along it     two points of b stay on the line
//   three slides, three hinges       nothing
// What acts along one of several coordinates acts on joints that measure them: the azimuth of one hinge's line about
// the other's is the angle of this other, the tilt between the first and the last of three is that of the middle one.
#include <algorithm>

#include "io/articulation.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr double lever = 0.1;      // m: between the points that stand for a line or a plane
constexpr double meeting = 1e-7;   // m: lines that come so near to each other meet
constexpr double parallel = 1e-7;  // sine of the angle
constexpr Real infinity = std::numeric_limits<Real>::infinity();

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

// A coordinate of a joint against that of a degree: turned round, and shifted.
struct Measure {
  double sign = 1, start = 0;
  double operator()(double x) const { return start + sign * x; }
  double rate(double x) const { return sign * x; }
};

std::optional<Limit> limit_of(const Degree& d, const Measure& m = {}) {
  if (!d.range) return {};
  const double p = m(d.range->first), q = m(d.range->second);
  return Limit{Real(min(p, q)), Real(max(p, q))};
}

// All that acts along a degree, a drive for each.
std::vector<Drive> drives_of(const Degree& d, const Measure& m = {}) {
  std::vector<Drive> drives;
  for (const Spring& s : d.springs) {
    drives.push_back({.mode = DriveMode::spring,
                      .target = Real(m(s.rest)),
                      .force = Real(s.force),
                      .stiffness = Real(s.stiffness),
                      .damping = Real(s.damping),
                      .rate = Real(m.rate(s.rate))});
  }
  if (d.armature > 0) {
    if (drives.empty() || drives[0].force < infinity)
      drives.insert(drives.begin(), {.mode = DriveMode::spring, .force = infinity});
    drives[0].armature = Real(d.armature);
  }
  if (d.friction > 0) drives.push_back({.mode = DriveMode::speed, .force = Real(d.friction)});
  return drives;
}

class Connection {
 public:
  Connection(Model& model, Remarks& remarks, Body a, Body b, std::span<const Degree> degrees)
      : model_(model), remarks_(remarks), a_(a), b_(b), degrees_(degrees) {}

  void make() {
    if (degrees_.size() == 1) {
      one(degrees_[0]);
    } else if (!several()) {
      remarks_.warn(
          degrees_[0].from,
          "begins a chain of joints without mass between them, which cannot be made: the two links move freely "
          "against each other");
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
  void stay_in_plane(const Vec3d& at, const Vec3d& normal) {
    const Vec3d x = any_perpendicular(normal), y = cross(normal, x);
    for (const auto& [i, k] : {std::pair{1.0, 0.0}, {-0.5, 0.75}, {-0.5, -0.75}})
      plane(at + (x * i + y * k) * lever, normal);
  }
  // A point of b stays on the line.
  void stay_on_line(const Vec3d& at, const Vec3d& direction) {
    const Vec3d x = any_perpendicular(direction);
    plane(at, x), plane(at, cross(direction, x));
  }

  // What acts along a degree, on joints that measure it: as many as there are drives, and one at least for a limit.
  template <class Def>
  void act(const Degree& d, Def measuring, const Measure& m = {}) {
    std::vector<Drive> drives = drives_of(d, m);
    const std::optional<Limit> limit = limit_of(d, m);
    if (drives.empty() && limit) drives.push_back({});
    if (limit) measuring.limit = *limit;
    for (const Drive& drive : drives) {
      measuring.drive = drive;
      model_.joints.push_back({measuring, d.from, d.name});
      measuring.limit = {};
    }
  }
  // Of a hinge about an axis that is fixed to a, where the direction is fixed to b and its azimuth the hinge's angle.
  void act_about(const Degree& d, const Vec3d& direction) {
    act(d, Azimuth{.a = a_,
                   .b = b_,
                   .at = position(d.at),
                   .axis = convert<Real>(d.axis),
                   .direction = convert<Real>(direction)});
  }
  // The same where the axis is fixed to b.
  void act_about_own(const Degree& d, const Vec3d& direction) {
    act(d, Azimuth{.a = b_,
                   .b = a_,
                   .at = position(d.at),
                   .axis = convert<Real>(-d.axis),
                   .direction = convert<Real>(direction)});
  }
  // Of a slide: a point of b along an axis of a, or the other way round.
  void act_along(const Degree& d, const Vec3d& at, bool of_a = true) {
    const Vec3d axis = of_a ? d.axis : -d.axis;
    act(d, Stroke{.a = of_a ? a_ : b_, .b = of_a ? b_ : a_, .at = position(at), .axis = convert<Real>(axis)});
  }
  void leave_out_what_acts(const Degree& d, const char* why) {
    if (d.range || !d.springs.empty() || d.friction > 0 || d.armature > 0)
      remarks_.warn(d.from, std::string("its range, spring, damping, friction and armature are left out: ") + why);
  }

  void one(const Degree& d) {
    if (d.kind == Freedom::ball) {
      leave_out_what_acts(d, "it is a ball joint");
      ball(d.at);
      return;
    }
    const auto make = [&]<class Def>(Def def) {
      def.a = a_, def.b = b_, def.at = position(d.at), def.axis = convert<Real>(d.axis);
      if (const auto limit = limit_of(d)) def.limit = *limit;
      const std::vector<Drive> drives = drives_of(d);
      if (!drives.empty()) def.drive = drives[0];
      model_.joints.push_back({def, d.from, d.name});
      for (std::size_t k = 1; k < drives.size(); ++k) {
        if constexpr (std::is_same_v<Def, Hinge>)
          add(Azimuth{.a = a_,
                      .b = b_,
                      .at = def.at,
                      .axis = def.axis,
                      .direction = any_perpendicular(def.axis),
                      .drive = drives[k]});
        else
          add(Stroke{.a = a_, .b = b_, .at = def.at, .axis = def.axis, .drive = drives[k]});
      }
    };
    if (d.kind == Freedom::hinge)
      make(Hinge{});
    else
      make(Slider{});
  }

  // False: such a chain is none of those above.
  bool several() {
    std::vector<const Degree*> hinges, slides;  // from the parent outwards
    for (const Degree& d : degrees_) {
      if (d.kind == Freedom::ball) return false;
      (d.kind == Freedom::hinge ? hinges : slides).push_back(&d);
    }
    if (!slides.empty() && !independent(slides)) return false;
    if (slides.empty() && hinges.size() == 2) return two_hinges(*hinges[0], *hinges[1]);
    if (slides.empty() && hinges.size() == 3) return three_hinges(*hinges[0], *hinges[1], *hinges[2], true);
    if (hinges.empty()) return slides_alone(slides);
    if (hinges.size() == 1 && slides.size() == 1) return slide_and_hinge(*slides[0], *hinges[0]);
    if (hinges.size() == 1 && slides.size() == 2) return in_plane(*slides[0], *slides[1], *hinges[0]);
    const bool slides_first =
        degrees_.size() == 6 && slides.size() == 3 && slides[2] < hinges[0];  // both are of degrees_
    return slides_first && six(slides, hinges);
  }

  static bool independent(std::span<const Degree* const> slides) {
    if (slides.size() > 3) return false;
    for (const Degree* p : slides) {
      for (const Degree* q : slides) {
        if (p != q && along(p->axis, q->axis)) return false;
      }
    }
    return slides.size() < 3 || abs(dot(slides[0]->axis, cross(slides[1]->axis, slides[2]->axis))) > 1e-3;
  }
  // Slides that are across each other are measured each for itself.
  void act_along_all(std::span<const Degree* const> slides, const Vec3d& at, bool of_a = true) {
    for (const Degree* p : slides) {
      if (std::ranges::all_of(slides, [&](const Degree* q) { return p == q || across(p->axis, q->axis); }))
        act_along(*p, at, of_a);
      else
        leave_out_what_acts(*p, "another slide is askew to it");
    }
  }

  bool two_hinges(const Degree& p, const Degree& q) {
    if (along(p.axis, q.axis)) {
      if (on_line(p.at, q)) return false;  // one line: two hinges are one, and the coordinates nobody's
      stay_in_plane(q.at, q.axis);
      bar(p.at + p.axis * dot(q.at - p.at, p.axis), q.at);
      for (const Degree* d : {&p, &q}) leave_out_what_acts(*d, "another joint of the body is parallel to it");
      return true;
    }
    const auto [on_p, on_q] = nearest(p, q);
    const double apart = length(on_q - on_p);
    if (apart < meeting) {
      ball(on_p);
      bar(on_p + p.axis * lever, on_p + q.axis * lever);
    } else {
      for (const double i : {-apart, apart}) {
        for (const double k : {-apart, apart}) bar(on_p + p.axis * i, on_q + q.axis * k);
      }
    }
    act_about(p, q.axis), act_about_own(q, p.axis);
    return true;
  }

  // `held`: their meeting point is of a and of b.
  bool three_hinges(const Degree& p, const Degree& q, const Degree& r, bool held) {
    const double volume = dot(q.axis, cross(r.axis, p.axis));
    if (along(p.axis, q.axis) || abs(volume) < 1e-3) return false;
    const auto [at, also] = nearest(p, q);
    if (length(also - at) > meeting || !on_line(at, r)) return false;
    if (held) ball(at);
    if (!across(p.axis, q.axis) || !across(q.axis, r.axis)) {
      for (const Degree* d : {&p, &q, &r}) leave_out_what_acts(*d, "the three joints of the body are askew");
      return true;
    }
    act_about(p, r.axis), act_about_own(r, p.axis);
    // Of the middle one, which neither body holds: the angle from the first to the last.
    const double sign = volume > 0 ? -1 : 1;  // q·(p × r)
    const double start = atan2(length(cross(p.axis, r.axis)), dot(p.axis, r.axis));
    act(q,
        Tilt{.a = a_, .b = b_, .at = position(at), .axis = convert<Real>(p.axis), .direction = convert<Real>(r.axis)},
        {sign, start});
    return true;
  }

  bool slides_alone(std::span<const Degree* const> slides) {
    const Vec3d& at = slides[0]->at;
    add(Orientation{.a = a_, .b = b_, .at = position(at)});
    if (slides.size() == 2) plane(at, normalize(cross(slides[0]->axis, slides[1]->axis)));
    act_along_all(slides, at);
    return true;
  }

  bool slide_and_hinge(const Degree& slide, const Degree& hinge) {
    const bool slide_first = &slide < &hinge;  // both are of degrees_
    if (along(slide.axis, hinge.axis)) {
      stay_on_line(hinge.at, hinge.axis), stay_on_line(hinge.at + hinge.axis * lever, hinge.axis);
    } else if (across(slide.axis, hinge.axis)) {
      stay_in_plane(hinge.at, hinge.axis);
      plane(hinge.at, cross(hinge.axis, slide.axis), slide_first);
    } else {
      return false;
    }
    act_along(slide, hinge.at, slide_first);
    act_about(hinge, any_perpendicular(hinge.axis));
    return true;
  }

  bool in_plane(const Degree& slide, const Degree& other, const Degree& hinge) {
    if (!across(slide.axis, hinge.axis) || !across(other.axis, hinge.axis)) return false;
    stay_in_plane(hinge.at, hinge.axis);
    const Degree* const slides[] = {&slide, &other};
    const bool slides_first = &slide < &hinge, both = (&other < &hinge) == slides_first;
    if (both)
      act_along_all(slides, hinge.at, slides_first);
    else
      for (const Degree* d : slides) leave_out_what_acts(*d, "a hinge stands between two slides");
    act_about(hinge, any_perpendicular(hinge.axis));
    return true;
  }

  bool six(std::span<const Degree* const> slides, std::span<const Degree* const> hinges) {
    if (!three_hinges(*hinges[0], *hinges[1], *hinges[2], false)) return false;
    act_along_all(slides, nearest(*hinges[0], *hinges[1]).first);
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
