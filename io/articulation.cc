#include "io/articulation.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

Pos position(const Vec3d& p) { return {p.x, p.y, p.z}; }
Mat3 rounded(const Mat3d& m) { return {convert<Real>(m.c0), convert<Real>(m.c1), convert<Real>(m.c2)}; }

// A body of that mass must have some inertia, one that a body can have.
Mat3d sound_inertia(const Inertial& i, const Link& link, Remarks& remarks) {
  const double largest = trace(i.inertia);
  if (!(largest > 0) || !at_least(i.inertia, 1e-9 * largest)) {
    remarks.warn(link.from, "has a mass, but an inertia that is not positive: that of a ball of 10 cm radius is taken");
    return Mat3d::identity() * (0.4 * i.mass * 0.01);
  }
  if (has_body(i.inertia)) return i.inertia;
  remarks.warn(link.from,
               "has an inertia of no body, one of whose principal moments is greater than the sum of the others: "
               "their mean is taken for all");
  return Mat3d::identity() * (largest / 3);
}

}

// Springs without a limit add up to one.
void Degree::add(const Spring& s) {
  if (!(s.stiffness > 0 || s.damping > 0)) return;
  if (!springs.empty() && s.force == infinite && springs[0].force == infinite) {
    Spring& all = springs[0];
    const double stiffness = all.stiffness + s.stiffness;
    if (stiffness > 0) all.rest = (all.stiffness * all.rest + s.stiffness * s.rest) / stiffness;
    const double damping = all.damping + s.damping;
    if (damping > 0) all.rate = (all.damping * all.rate + s.damping * s.rate) / damping;
    all.stiffness = stiffness, all.damping = damping;
  } else {
    springs.insert(s.force == infinite ? springs.begin() : springs.end(), s);
  }
}

bool Articulation::meets_nothing(std::size_t c) const { return std::ranges::none_of(touching[c], std::identity{}); }

Assembly::Assembly(Articulation mechanism, Model& model, Source& source, Remarks& remarks)
    : mechanism_(std::move(mechanism)), model_(model), source_(source), remarks_(remarks) {
  for (const Link& link : mechanism_.links) {
    const Frame outer = link.parent == ground ? Frame{{}, z_up()} : frames_[std::size_t(link.parent)];
    frames_.push_back(outer * link.at);
  }
  shorten();
  find_roots();
  add_bodies();
  for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
    const Link& link = mechanism_.links[i];
    if (link.degrees.empty()) continue;
    std::vector<Degree> degrees = link.degrees;
    for (Degree& d : degrees) d.at = frames_[i].point(d.at), d.axis = rotate(frames_[i].q, d.axis);
    for (std::size_t k = 0; k < degrees.size(); ++k) source_.count_item();
    connect(model_, remarks_, body_of(link.parent), body_of(int(i)), degrees);
  }
}

Frame Assembly::frame_of(int link) const { return link == ground ? Frame{{}, z_up()} : frames_[std::size_t(link)]; }

Body Assembly::body_of(int link) const {
  const int root = root_of(link);
  return root == ground ? Body{} : body_number(std::size_t(bodies_[std::size_t(root)]));
}

void Assembly::join(JointDef def, const Origin& from, const std::string& name) {
  source_.count_item();
  model_.joints.push_back({std::move(def), from, name});
}

void Assembly::find_roots() {
  roots_.assign(mechanism_.links.size(), ground);
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    const Link& link = mechanism_.links[i];
    const bool moves = link.free || link.kinematic || !link.degrees.empty();
    roots_[i] = moves ? int(i) : root_of(link.parent);
  }
  parts_.assign(roots_.size(), {});
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (roots_[i] != ground) parts_[std::size_t(roots_[i])].push_back(int(i));
  }
}

// A link without mass cannot be a body of its own: its degrees of freedom become those of what it carries.
void Assembly::shorten() {
  find_roots();
  std::vector<Link>& links = mechanism_.links;
  std::vector<double> mass(links.size());
  std::vector<std::vector<int>> carried(links.size());  // roots, by root
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (roots_[i] != ground) mass[std::size_t(roots_[i])] += links[i].inertial.mass;
    const int holder = root_of(links[i].parent);
    if (roots_[i] == int(i) && holder != ground) carried[std::size_t(holder)].push_back(int(i));
  }
  const auto massless = [&](std::size_t i) { return roots_[i] == int(i) && !links[i].kinematic && !(mass[i] > 0); };
  const auto leave_pieces = [&](std::size_t root) {
    for (const int part : parts_[root]) links[std::size_t(part)].pieces.clear();
  };
  for (std::size_t i = links.size(); i-- > 0;) {
    if (!massless(i) || !carried[i].empty()) continue;
    remarks_.warn(links[i].from, "moves, but has no mass and carries nothing: left out");
    links[i].degrees.clear(), links[i].free = false, leave_pieces(i);
    const int holder = root_of(links[i].parent);
    if (holder != ground) std::erase(carried[std::size_t(holder)], int(i));
    roots_[i] = holder;
  }
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!massless(i) || carried[i].empty()) continue;
    if (carried[i].size() > 1) {
      remarks_.warn(links[i].from, "moves, but has no mass, and carries several links: it is held where it is");
      links[i].degrees.clear(), links[i].free = false;
      continue;
    }
    const auto c = std::size_t(carried[i][0]);
    Link& next = links[c];
    const Frame between = inverse(frames_[c]) * frames_[i];
    std::vector<Degree> degrees = links[i].degrees;
    for (Degree& d : degrees) d.at = between.point(d.at), d.axis = rotate(between.q, d.axis);
    if (!links[i].free) next.degrees.insert(next.degrees.begin(), degrees.begin(), degrees.end());
    if (!links[i].pieces.empty()) {
      remarks_.warn(links[i].from,
                    "moves, but has no mass: what it looks like is left out, what it carries takes its joint");
      leave_pieces(i);
    }
    next.free = next.free || links[i].free;
    if (next.free) next.degrees.clear();
    next.parent = links[i].parent;
    links[i].degrees.clear(), links[i].free = false;
  }
}

void Assembly::add_bodies() {
  bodies_.assign(mechanism_.links.size(), -1);
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (roots_[i] == int(i)) {
      add_body(int(i));
    } else if (roots_[i] == ground && !mechanism_.links[i].pieces.empty()) {
      add_still(int(i));
    }
  }
}

ShapeDef Assembly::shape_def(const Piece& piece, const Frame& in_body) const {
  const Frame at = in_body * piece.at;
  ShapeDef def{.shape = piece.shape, .at = convert<Real>(at.p), .turn = convert<Real>(at.q)};
  def.material = piece.material;
  Filter filter{.category = std::uint32_t(1) << piece.meets, .mask = 0};
  for (std::size_t k = 0; k < mechanism_.touching.size(); ++k) {
    if (mechanism_.touching[piece.meets][k]) filter.mask |= std::uint32_t(1) << k;
  }
  def.filter = filter;
  return def;
}

void Assembly::add_body(int root) {
  const Link& link = mechanism_.links[std::size_t(root)];
  const Frame& frame = frames_[std::size_t(root)];
  const std::vector<int>& parts = parts_[std::size_t(root)];
  BodyDef def{.at = position(frame.p), .turn = convert<Real>(frame.q), .name = link.name};
  def.motion = link.kinematic ? Motion::kinematic : Motion::dynamic;
  Inertial all{};
  double lifted = 0;  // kg: at which gravity pulls
  bool touches = false;
  for (const int i : parts) {
    const Link& part = mechanism_.links[std::size_t(i)];
    lifted += part.inertial.mass * part.gravity;
    all = together(all, moved(part.inertial, inverse(frame) * frames_[std::size_t(i)]));
    for (const Piece& p : part.pieces) touches = touches || !mechanism_.meets_nothing(p.meets);
  }
  for (const int i : parts) {
    const Frame in_body = inverse(frame) * frames_[std::size_t(i)];
    for (const Piece& p : mechanism_.links[std::size_t(i)].pieces) {
      if (touches && mechanism_.meets_nothing(p.meets)) continue;  // its looks alone, where there is another
      source_.count_item();
      def.shapes.push_back(shape_def(p, in_body));
    }
  }
  if (all.mass > 0) {
    def.mass = Real(all.mass);
    def.gravity_factor = Real(lifted / all.mass);
    def.center = convert<Real>(all.center);
    def.inertia = rounded(sound_inertia(all, link, remarks_));
  }
  if (def.shapes.empty()) {
    remarks_.note(link.from, "has no shape: it is seen as a ball, which touches nothing");
    const double radius = all.mass > 0 ? sqrt(2.5 * trace(all.inertia) / (3 * all.mass)) : 0;  // with such an inertia
    def.shapes.push_back({.shape = sphere(Real(clamp(radius, 0.01, 1.0)))});
    def.filter = {.category = 0, .mask = 0};
  }
  source_.count_item();
  bodies_[std::size_t(root)] = int(model_.bodies.size());
  model_.bodies.push_back({std::move(def), link.from, link.name});
}

void Assembly::add_still(int i) {
  const Link& link = mechanism_.links[std::size_t(i)];
  const Frame& frame = frames_[std::size_t(i)];
  BodyDef def{.at = position(frame.p), .turn = convert<Real>(frame.q), .motion = Motion::fixed, .name = link.name};
  for (const Piece& p : link.pieces) {
    source_.count_item();
    def.shapes.push_back(shape_def(p, {}));
  }
  source_.count_item();
  bodies_[std::size_t(i)] = int(model_.bodies.size());
  model_.bodies.push_back({std::move(def), link.from, link.name});
}

}
