#include "io/gltf/joints.h"

#include <algorithm>
#include <cmath>

namespace sudar::inline SUDAR_PRECISION::io::gltf {

namespace {

// What may be of one axis of a joint's frame: between low and high, in m or rad.
struct Axis {
  double low = -infinite, high = infinite;
  std::optional<JsonValue> drive{};
  bool locked() const { return low == high; }
  bool free() const { return low == -infinite && high == infinite; }
  Limit limit() const { return {Real(low), Real(high)}; }
};

struct Description {
  Axis linear[3], angular[3];
  std::optional<double> distance{};  // of the two points, at most
};

int locked(const Axis (&axes)[3]) { return int(std::ranges::count_if(axes, &Axis::locked)); }
int free_ones(const Axis (&axes)[3]) { return int(std::ranges::count_if(axes, &Axis::free)); }
int first_open(const Axis (&axes)[3]) {  // the first axis that is not locked
  return int(std::ranges::find_if_not(axes, &Axis::locked) - std::begin(axes));
}

void read_limit(const JsonValue& limit, Description& d) {
  const bool linear = bool(limit["linearAxes"]);
  if (linear == bool(limit["angularAxes"])) limit.refuse("must have either linearAxes or angularAxes");
  std::vector<std::size_t> axes;
  for (const JsonValue& axis : limit[linear ? "linearAxes" : "angularAxes"].elements()) {
    const std::size_t i = axis.index(3);
    if (std::ranges::find(axes, i) != axes.end()) axis.refuse("is there twice");
    axes.push_back(i);
  }
  const double low = limit["min"].number(-infinite), high = limit["max"].number(infinite);
  if (low > high) limit["min"].refuse("is greater than max");
  if (limit["stiffness"]) limit.warn("is soft (stiffness), which is not supported; read as a hard limit");
  if (axes.size() > 1 && !(low == 0 && high == 0)) {
    if (high == infinite) return;  // a distance has no other end than 0
    if (linear && axes.size() == 3) {
      d.distance = std::min(high, d.distance.value_or(high));
      if (low > 0) limit["min"].warn("is greater than 0: that points keep apart is not supported; left out");
    } else {
      limit.warn(linear ? "keeps a distance from a line, which is not supported; left out"
                        : "is a cone, which is not supported; left out");
    }
    return;
  }
  for (const std::size_t i : axes) {
    Axis& axis = linear ? d.linear[i] : d.angular[i];
    axis.low = std::max(axis.low, low), axis.high = std::min(axis.high, high);
    if (axis.low > axis.high) limit.refuse("leaves nothing of what another limit of the axis allows");
  }
}

Description read_description(const JsonValue& def) {
  Description d;
  for (const JsonValue& limit : def["limits"].elements()) read_limit(limit, d);
  for (const JsonValue& drive : def["drives"].elements()) {
    const std::string type = drive["type"].text();
    if (type != "linear" && type != "angular")
      drive["type"].refuse("\"" + type + "\" given, linear or angular expected");
    const std::size_t which = drive["axis"].index(3);
    Axis& axis = type == "linear" ? d.linear[which] : d.angular[which];
    if (axis.drive)
      drive.warn("is a second drive of its axis; left out");
    else
      axis.drive = drive;
  }
  return d;
}

// --- inertia that a drive feels ---

// One of a joint's rows: what it does to the velocities of the two bodies.
struct Row {
  Vec3d linear, angular_a, angular_b;  // on a: −linear, −angular_a
};
struct Inertia {
  double inverse_mass = 0;
  Mat3d inverse = Mat3d::diagonal({});
  Vec3d arm;
};
Inertia inertia_of(const World& w, Body body, const Pos& anchor) {
  Inertia result;
  if (body.null() || w[body].motion() != Motion::dynamic) return result;
  const BodyView view = w[body];
  const Mat3 tensor = view.inertia();
  result.inverse_mass = 1 / double(view.mass());
  result.inverse = inverse(Mat3d{convert<double>(tensor.c0), convert<double>(tensor.c1), convert<double>(tensor.c2)});
  result.arm = convert<double>(anchor - view.center());
  return result;
}
double response(const Row& r, const Row& s, const Inertia& a, const Inertia& b) {
  return dot(r.linear, s.linear) * (a.inverse_mass + b.inverse_mass) + dot(r.angular_a, a.inverse * s.angular_a) +
         dot(r.angular_b, b.inverse * s.angular_b);
}

// What a drive along `free` moves while the joint's other rows hold: 1 / (d − cᵀ A⁻¹ c) (dynamics/drives.h has the
// same).
double effective_mass(std::vector<Row> rows, const Row& free, const Inertia& a, const Inertia& b) {
  rows.push_back(free);
  const std::size_t n = rows.size();
  std::vector<std::vector<double>> m(n, std::vector<double>(n));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < n; ++k) m[i][k] = response(rows[i], rows[k], a, b);
  }
  // Eliminated down to the last: what is left there is its Schur complement.
  for (std::size_t p = 0; p + 1 < n; ++p) {
    if (!(m[p][p] > 0)) continue;
    for (std::size_t i = p + 1; i < n; ++i) {
      const double f = m[i][p] / m[p][p];
      for (std::size_t k = p; k < n; ++k) m[i][k] -= f * m[p][k];
    }
  }
  return m[n - 1][n - 1] > 0 ? 1 / m[n - 1][n - 1] : 0;
}

// --- one joint ---

class Joining {
 public:
  Joining(const JsonValue& joint, const Description& d, const Frame& a, const Frame& b, Body body_a, Body body_b,
          const World& trial, const std::vector<Body>& bodies, Model& model)
      : json_(joint), d_(d), a_(a), body_a_(body_a), body_b_(body_b), trial_(trial), bodies_(bodies), model_(model) {
    collide_ = joint["enableCollision"].flag(false);
    meet(b);
  }

  void make() {
    const int fixed_ways = locked(d_.linear), fixed_turns = locked(d_.angular);
    const Axis& turn = d_.angular[first_open(d_.angular) % 3];
    const int way = first_open(d_.linear) % 3;
    if (fixed_ways == 3 && fixed_turns == 3) return add(Fixed{.at = at()}, {});
    if (fixed_ways == 3 && fixed_turns == 2)
      return add(Hinge{.at = at(), .axis = axis(first_open(d_.angular)), .limit = turn.limit()}, turn.drive);
    if (fixed_ways == 2 && fixed_turns == 3)
      return add(Slider{.at = at(), .axis = axis(way), .limit = d_.linear[way].limit()}, d_.linear[way].drive);
    if (fixed_ways == 3) {
      if (free_ones(d_.angular) < 3)
        warn("turns about two axes or within limits, which is not supported: read as a ball joint, which turns freely");
      return add(Ball{.at = at()}, {});
    }
    if (fixed_turns > 0 && !(fixed_ways == 2 && fixed_turns == 2 && d_.angular[way].free())) {
      warn("locks turns without holding a point, which is not supported: they stay free");
      return keep_ways(false);
    }
    keep_ways(fixed_turns == 2);
  }

 private:
  Pos at() const { return pose_of(a_).p; }
  Vec3 axis(int k) const {
    Vec3d e;
    e[k] = 1;
    return convert<Real>(rotate(a_.q, e));
  }
  void warn(const std::string& message) const { json_.warn(message); }

  // A lock need not be at 0: the frame on a moves on to where b's is held. Then b is brought to where the two frames
  // meet.
  void meet(const Frame& b) {
    Frame lock;
    for (int k = 0; k < 3; ++k) {
      Axis &way = d_.linear[k], &turn = d_.angular[k];
      if (way.locked()) lock.p[k] = way.low, way.low = way.high = 0;
      if (!turn.locked() || turn.low == 0) continue;
      Vec3d about;
      about[k] = turn.low;
      lock.q = lock.q * rotation(about);
      turn.low = turn.high = 0;
    }
    actual_b_ = {b.p.x, b.p.y, b.p.z};
    actual_a_ = at();
    a_ = a_ * lock;
    const bool moves_b = !body_b_.null();
    const Frame from = moves_b ? b : a_, to = moves_b ? a_ : b;
    if (!moves_b) a_ = b;
    const Frame shift = to * inverse(from);
    if (length(shift.point(from.p) - from.p) < 1e-6 && length(shift.q.vector()) < 1e-6) return;
    const Body moved = moves_b ? body_b_ : body_a_;
    const BodyDef& def = model_.bodies[moved.index].def;
    const Frame now{{def.at.x, def.at.y, def.at.z}, convert<double>(normalize(def.turn))};
    place_ = {moved, pose_of(shift * now)};
  }

  // Points that stay in planes: on a line, if there are two; `turns` that only about it.
  void keep_ways(bool only_about_line) {
    const auto planes = [&](const Pos& point) {
      for (int k = 0; k < 3; ++k) {
        if (d_.linear[k].locked()) add(sudar::Plane{.at = point, .normal = axis(k)}, {});
      }
    };
    planes(at());
    const int way = first_open(d_.linear) % 3;
    if (only_about_line) planes(at() + axis(way));
    bool limited = false;
    double corner = 0;  // square of how far the limits let the points part
    for (const Axis& w : d_.linear) {
      limited |= !w.locked() && !w.free();
      if (!w.locked()) corner += square(max(abs(w.low), abs(w.high)));
      if (w.drive) w.drive->warn("drives an axis of a joint that has no such drive here; left out");
    }
    if (d_.distance) rope(*d_.distance);
    if (!limited) return;
    if (corner == infinite) return warn("limits ways in a manner that is not supported: they stay free");
    const Axis& only = d_.linear[way];
    if (locked(d_.linear) < 2 || only.low != -only.high)
      warn("limits ways along axes: read as a rope that reaches the farthest corner");
    rope(sqrt(corner));
  }
  void rope(double length) {
    if (!(length > 0)) return add(Ball{.at = at()}, {});
    JointItem item{sudar::Rope{.a = body_a_,
                               .b = body_b_,
                               .at_a = actual_a_,
                               .at_b = actual_b_,
                               .length = Real(length),
                               .collide = collide_},
                   json_.origin(),
                   "",
                   {}};
    model_.joints.push_back(std::move(item));
    made_ = true;
  }

  template <class Def>
  void add(Def def, const std::optional<JsonValue>& drive) {
    def.a = body_a_, def.b = body_b_, def.collide = collide_;
    if constexpr (requires { def.drive; }) {
      if (drive) def.drive = driven(*drive, def.axis, std::is_same_v<Def, Hinge>);
    }
    for (const auto& axes : {std::span<const Axis>(d_.linear), std::span<const Axis>(d_.angular)}) {
      for (const Axis& a : axes) {
        const bool used = drive && a.drive && a.drive->pointer() == drive->pointer();
        if (a.drive && !used && !made_)
          a.drive->warn("drives an axis of a joint that has no such drive here; left out");
      }
    }
    made_ = true;
    JointItem item{std::move(def), json_.origin(), "", place_};
    model_.joints.push_back(std::move(item));
  }

  Drive driven(const JsonValue& json, const Vec3& axis, bool turns) const {
    Drive drive{.mode = DriveMode::spring,
                .target = Real(json["positionTarget"].number(0)),
                .force = std::numeric_limits<Real>::infinity()};
    if (json["maxForce"]) drive.force = Real(json["maxForce"].number_from(0, 0));
    const std::string mode = json["mode"].text("force");
    if (mode != "force" && mode != "acceleration")
      json["mode"].refuse("\"" + mode + "\" given, force or acceleration expected");
    const double factor = mode == "force" ? 1 : felt_mass(axis, turns);
    drive.stiffness = Real(json["stiffness"].number_from(0, 0) * factor);
    drive.damping = Real(json["damping"].number_from(0, 0) * factor);
    drive.rate = Real(json["velocityTarget"].number(0));
    return drive;
  }

  double felt_mass(const Vec3& axis, bool turns) const {
    const auto inertia = [&](Body body) {
      if (body.null()) return Inertia{};
      return inertia_of(trial_, bodies_[body.index], body == body_b_ ? actual_b_ : actual_a_);
    };
    const Inertia a = inertia(body_a_), b = inertia(body_b_);
    const Vec3d n = convert<double>(axis), u = any_perpendicular(n), v = cross(n, u);
    const auto linear = [&](const Vec3d& e) { return Row{e, cross(a.arm, e), cross(b.arm, e)}; };
    const auto angular = [](const Vec3d& e) { return Row{{}, e, e}; };
    if (turns) return effective_mass({linear(n), linear(u), linear(v), angular(u), angular(v)}, angular(n), a, b);
    return effective_mass({linear(u), linear(v), angular(n), angular(u), angular(v)}, linear(n), a, b);
  }

  const JsonValue json_;
  Description d_;
  Frame a_;
  Body body_a_, body_b_;
  const World& trial_;
  const std::vector<Body>& bodies_;
  Model& model_;
  bool collide_ = false, made_ = false;
  Pos actual_a_, actual_b_;
  std::optional<JointItem::Place> place_;
};

}

void read_joints(Document& doc, const SceneTree& tree, const Bodies& bodies, Model& model) {
  const JsonValue descriptions = doc.root()["extensions"]["KHR_physics_rigid_bodies"]["physicsJoints"];
  std::optional<World> trial;  // tells what bodies weigh
  std::vector<Body> handles;
  for (const std::size_t i : tree.order) {
    const JsonValue joint = tree.nodes[i].physics()["joint"];
    if (!joint) continue;
    doc.source().count_item();
    const std::size_t other = joint["connectedNode"].index(tree.nodes.size());
    if (!tree.nodes[other].present) {
      joint["connectedNode"].warn("is node " + std::to_string(other) +
                                  ", which is not in the scene; the joint is left out");
      continue;
    }
    const auto a = bodies.body_of(i), b = bodies.body_of(other);
    const auto moves = [&](const std::optional<std::size_t>& k) {
      return k && model.bodies[*k].def.motion == Motion::dynamic;
    };
    if (a == b || (!moves(a) && !moves(b))) {
      joint.warn(a == b ? "joins a body with itself; left out" : "joins what does not move; left out");
      continue;
    }
    if (!trial) {
      trial.emplace(model.config);
      Model only_bodies{.config = model.config, .bodies = model.bodies};
      handles = build(only_bodies, *trial).bodies;
    }
    const Description d = read_description(descriptions.element(joint["joint"].index(descriptions.size())));
    const auto handle = [](const std::optional<std::size_t>& k) { return k ? body_number(*k) : Body{}; };
    Joining(joint, d, tree.nodes[i].frame(), tree.nodes[other].frame(), handle(a), handle(b), *trial, handles, model)
        .make();
  }
}

}
