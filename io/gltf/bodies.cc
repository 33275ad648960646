#include "io/gltf/bodies.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io::gltf {

namespace {

// In the order in which they decide when two materials differ; who says nothing has no vote, and where both say
// nothing, the average is taken.
constexpr const char* combine_modes[] = {"average", "minimum", "maximum", "multiply"};

std::optional<std::size_t> combine_mode(const JsonValue& value) {
  if (!value) return {};
  const std::string text = value.text();
  const auto it = std::find(std::begin(combine_modes), std::end(combine_modes), text);
  if (it == std::end(combine_modes)) {
    value.warn("\"" + text + "\" is no way to combine; average taken");
    return {};
  }
  return std::size_t(it - std::begin(combine_modes));
}

std::size_t decided(const std::optional<std::size_t>& a, const std::optional<std::size_t>& b) {
  return a && b ? std::min(*a, *b) : a ? *a : b.value_or(0);
}

Real combined(std::size_t mode, Real a, Real b) {
  switch (mode) {
    case 0:
      return (a + b) / 2;
    case 1:
      return min(a, b);
    case 2:
      return max(a, b);
    default:
      return a * b;
  }
}

// A filter has 32 bits; the last stands for colliders that are in no system.
constexpr std::size_t most_systems = 31;
constexpr std::uint32_t no_system = 1u << most_systems;
constexpr std::size_t no_material = 0;

// What a part adds to its body.
Inertial inertial_of(const ShapeDef& part, const std::optional<MassProperties>& own, double density) {
  const MassProperties unit = own ? *own : part.shape.mass_properties();
  return moved(io::inertial_of(unit, unit.volume * density), {convert<double>(part.at), convert<double>(part.turn)});
}

Vec3 own_center(const BodyDef& def) {
  Inertial sum;
  for (const ShapeDef& s : def.shapes) sum = together(sum, inertial_of(s, {}, double(def.density)));
  return convert<Real>(sum.center);
}

}

Bodies::Bodies(Document& doc, const SceneTree& tree, Model& model)
    : doc_(doc),
      tree_(tree),
      model_(model),
      geometry_(doc, tree),
      moving_(tree.nodes.size()),
      standing_(tree.nodes.size()) {
  read_materials();
  read_filters();
  model_.config.friction_mix = model_.config.restitution_mix = Mix::average;
  std::vector<std::optional<std::size_t>> owner(tree.nodes.size());
  std::vector<std::size_t> roots, obstacles;
  std::vector<std::vector<std::size_t>> parts(tree.nodes.size());
  for (const std::size_t i : tree.order) {
    const Node& node = tree.nodes[i];
    if (node.parent != no_node) owner[i] = owner[node.parent];
    const JsonValue physics = node.physics();
    if (physics["motion"]) owner[i] = i, roots.push_back(i);
    if (physics["trigger"]) physics["trigger"].warn("triggers are not supported; left out");
    if (physics["collider"] && owner[i]) parts[*owner[i]].push_back(i);
    if (physics["collider"] && !owner[i]) obstacles.push_back(i);
  }
  colliders_ = std::move(parts);
  for (const std::size_t i : roots) add_body(i);
  for (const std::size_t i : obstacles) add_obstacle(i);
  mix_pairs();
}

std::optional<std::size_t> Bodies::body_of(std::size_t node) const {
  for (std::size_t i = node; i != no_node; i = tree_.nodes[i].parent) {
    if (moving_[i]) return moving_[i];
  }
  for (std::size_t i = node; i != no_node; i = tree_.nodes[i].parent) {
    if (standing_[i]) return standing_[i];
  }
  return {};
}

void Bodies::read_materials() {
  materials_.push_back({});
  for (const JsonValue& m : doc_.root()["extensions"]["KHR_physics_rigid_bodies"]["physicsMaterials"].elements()) {
    const sudar::Material usual;
    Material read;
    read.values.friction_static = Real(m["staticFriction"].number_from(0, usual.friction_static));
    read.values.friction_dynamic = Real(m["dynamicFriction"].number_from(0, usual.friction_dynamic));
    double bounce = m["restitution"].number_from(0, 0);
    if (bounce > 1) m["restitution"].warn("is greater than 1, which would make energy; 1 taken"), bounce = 1;
    read.values.restitution = Real(bounce);
    read.friction_mode = combine_mode(m["frictionCombine"]);
    read.restitution_mode = combine_mode(m["restitutionCombine"]);
    materials_.push_back(read);
  }
}

void Bodies::read_filters() {
  std::map<std::string, std::uint32_t> systems;
  const auto bit = [&](const JsonValue& name) {
    const auto [it, fresh] = systems.try_emplace(name.text(), std::uint32_t(systems.size()));
    if (fresh && it->second == most_systems) {
      name.warn("there are more than " + std::to_string(most_systems) +
                " collision systems; this one and later ones share the last");
    }
    return 1u << std::min<std::uint32_t>(it->second, most_systems - 1);
  };
  const auto bits = [&](const JsonValue& list) {
    std::uint32_t sum = 0;
    for (const JsonValue& name : list.elements()) sum |= bit(name);
    return sum;
  };
  for (const JsonValue& f : doc_.root()["extensions"]["KHR_physics_rigid_bodies"]["collisionFilters"].elements()) {
    Filter filter{.category = bits(f["collisionSystems"])};
    if (filter.category == 0) filter.category = no_system;
    if (f["collideWithSystems"]) filter.mask = bits(f["collideWithSystems"]);
    filter.mask &= ~bits(f["notCollideWithSystems"]);
    filters_.push_back(filter);
  }
}

bool Bodies::add_collider(BodyDef& def, std::vector<std::optional<MassProperties>>& masses, const JsonValue& collider,
                          const Frame& body, const Affine& place, std::size_t number) {
  const Affine in_body = affine(inverse(body)) * place;
  const std::optional<Solid> solid = geometry_.solid(collider["geometry"], in_body, def.motion == Motion::dynamic);
  if (!solid) return false;
  ShapeDef part{.shape = solid->shape, .at = convert<Real>(solid->at.p), .turn = convert<Real>(solid->at.q)};
  std::size_t material = no_material;
  if (const JsonValue m = collider["physicsMaterial"]) material = 1 + m.index(materials_.size() - 1);
  part.material = materials_[material].values;
  if (const JsonValue f = collider["collisionFilter"])
    part.filter = filters_[f.index(filters_.size())];
  else
    part.filter = Filter{.category = no_system};
  if (used_.size() <= number) used_.resize(number + 1);
  if (std::ranges::find(used_[number], material) == used_[number].end()) used_[number].push_back(material);
  def.shapes.push_back(std::move(part));
  masses.push_back(solid->mass);
  return true;
}

void Bodies::add_obstacle(std::size_t i) {
  const Node& node = tree_.nodes[i];
  const Frame frame = node.frame();
  BodyDef def{.at = pose_of(frame).p, .turn = pose_of(frame).q, .motion = Motion::fixed, .name = tree_.name_of(i)};
  std::vector<std::optional<MassProperties>> unused;
  const JsonValue collider = node.physics()["collider"];
  if (!add_collider(def, unused, collider, frame, node.global, model_.bodies.size())) return;
  standing_[i] = model_.bodies.size();
  model_.bodies.push_back({std::move(def), collider.origin(), tree_.name_of(i)});
}

void Bodies::add_body(std::size_t i) {
  const Node& node = tree_.nodes[i];
  const JsonValue motion = node.physics()["motion"];
  const Frame frame = node.frame();
  const Vec3d scale_ = scaling_of(node.global.m).scale;
  const bool kinematic = motion["isKinematic"].flag(false);
  BodyDef def{.at = pose_of(frame).p,
              .turn = pose_of(frame).q,
              .motion = kinematic ? Motion::kinematic : Motion::dynamic,
              .name = tree_.name_of(i)};
  def.velocity = convert<Real>(rotate(frame.q, motion["linearVelocity"].vector({})));
  def.spin = convert<Real>(rotate(frame.q, motion["angularVelocity"].vector({})));
  def.gravity_factor = Real(motion["gravityFactor"].number(1));
  const std::size_t number = model_.bodies.size();
  std::vector<std::optional<MassProperties>> masses;
  for (const std::size_t c : colliders_[i]) {
    add_collider(def, masses, tree_.nodes[c].physics()["collider"], frame, tree_.nodes[c].global, number);
  }
  if (def.shapes.empty()) {  // it moves, but meets nothing
    motion.note("has no collider: it moves as a ball that touches nothing");
    def.shapes.push_back({.shape = sphere(Real(0.05)), .filter = Filter{.category = 0, .mask = 0}});
    masses.emplace_back();
    if (!motion["mass"]) def.mass = 1;
  }
  set_mass(def, motion, scale_, masses);
  moving_[i] = number;
  model_.bodies.push_back({std::move(def), motion.origin(), tree_.name_of(i)});
  if (!kinematic && motion["mass"] && motion["mass"].number() == 0) {
    const Vec3d moments = motion["inertiaDiagonal"].vector({});
    hold(number, motion, !motion["inertiaDiagonal"] || moments != Vec3d{});
  }
}

void Bodies::set_mass(BodyDef& def, const JsonValue& motion, const Vec3d& size,
                      const std::vector<std::optional<MassProperties>>& masses) {
  if (def.motion != Motion::dynamic) return;
  const double given = motion["mass"].number_from(0, 0);
  if (given > 0) def.mass = Real(given);
  Inertial own;
  bool as_shapes = true;  // what the engine finds is right
  for (std::size_t k = 0; k < masses.size(); ++k) {
    const ShapeDef& part = def.shapes[k];
    as_shapes = as_shapes && !masses[k];
    own = together(own, inertial_of(part, masses[k], double(def.density)));
  }
  const double mass = given > 0 ? given : own.mass, share = mass / own.mass;
  const JsonValue center = motion["centerOfMass"], moments = motion["inertiaDiagonal"];
  if (!as_shapes || center || moments) {
    def.mass = Real(mass);
    def.center = convert<Real>(center ? scale(size, center.vector({})) : own.center);
    const Mat3d tensor = own.inertia * share;
    def.inertia = Mat3{convert<Real>(tensor.c0), convert<Real>(tensor.c1), convert<Real>(tensor.c2)};
  }
  if (moments) set_inertia(def, motion, own);
}

// Zero stands for infinite: so large a moment that nothing turns it. A moment greater than the other two together,
// which no body has, becomes what those are.
void Bodies::set_inertia(BodyDef& def, const JsonValue& motion, const Inertial& own) {
  const JsonValue diagonal = motion["inertiaDiagonal"];
  Vec3d moments = diagonal.vector({});
  if (moments.x < 0 || moments.y < 0 || moments.z < 0) diagonal.refuse("has a negative moment");
  constexpr double large = 1e9;  // times what is usual here
  const int endless = (moments.x == 0) + (moments.y == 0) + (moments.z == 0);
  if (endless > 0) {
    const double usual = max(max_component(moments), trace(own.inertia) / 3 * double(def.mass) / own.mass);
    for (int k = 0; k < 3; ++k) moments[k] = moments[k] == 0 ? large * usual : moments[k];
    if (endless > 1) {
      diagonal.note("is infinite (0) about " + std::to_string(endless) + " axes: 10⁹ times a usual moment taken");
    }
  }
  for (int k = 0; k < 3; ++k) {
    const double others = moments[(k + 1) % 3] + moments[(k + 2) % 3];
    if (moments[k] <= others) continue;
    diagonal.warn("is of no body: the moment about axis " + std::to_string(k) +
                  " is greater than the other two together, which are taken instead");
    moments[k] = others;
  }
  const Mat3d axes = matrix(motion["inertiaOrientation"].rotation());
  const Mat3d tensor = axes * Mat3d::diagonal(moments) * transpose(axes);
  def.inertia = Mat3{convert<Real>(tensor.c0), convert<Real>(tensor.c1), convert<Real>(tensor.c2)};
}

// An infinite mass: the centre stays, held by a joint with the world. Where its inertia is infinite, too, nothing moves
// it.
void Bodies::hold(std::size_t number, const JsonValue& motion, bool turns) {
  BodyDef& def = model_.bodies[number].def;
  if (!turns) {
    def.motion = Motion::kinematic;
    return;
  }
  if (def.velocity != Vec3{}) {
    motion["mass"].warn("is infinite (0) on a body that goes and turns freely: it stays where it is");
    def.velocity = {};
  }
  const Pose pose{def.at, def.turn};
  const Pos at = pose.point(def.center ? *def.center : own_center(def));
  const Vec3d moments = motion["inertiaDiagonal"].vector({1, 1, 1});
  const int endless = (moments.x == 0) + (moments.y == 0) + (moments.z == 0);
  if (endless == 2) {
    const Vec3d own{moments.x == 0 ? 0. : 1., moments.y == 0 ? 0. : 1., moments.z == 0 ? 0. : 1.};
    const Vec3 axis = rotate(pose.q, convert<Real>(rotate(motion["inertiaOrientation"].rotation(), own)));
    model_.joints.push_back(
        {Hinge{.b = body_number(number), .at = at, .axis = normalize(axis)}, motion.origin(), "", {}});
  } else {
    model_.joints.push_back({Ball{.b = body_number(number), .at = at}, motion.origin(), "", {}});
  }
}

// What the world's own rule, the average, does not say.
void Bodies::mix_pairs() {
  used_.resize(model_.bodies.size());
  const auto votes = [](const Material& m) {
    return m.friction_mode.value_or(0) > 0 || m.restitution_mode.value_or(0) > 0;
  };
  if (std::ranges::none_of(materials_, votes)) return;
  constexpr std::size_t most = 200'000;
  for (std::size_t i = 0; i < used_.size(); ++i) {
    for (std::size_t k = i + 1; k < used_.size(); ++k) {
      if (used_[i].empty() || used_[k].empty()) continue;
      if (model_.bodies[i].def.motion != Motion::dynamic && model_.bodies[k].def.motion != Motion::dynamic) continue;
      const Material &a = materials_[used_[i].front()], &b = materials_[used_[k].front()];
      const std::size_t friction = decided(a.friction_mode, b.friction_mode),
                        bounce = decided(a.restitution_mode, b.restitution_mode);
      if (friction == 0 && bounce == 0) continue;
      if (used_[i].size() > 1 || used_[k].size() > 1) {
        doc_.source().warn(model_.bodies[i].from,
                           "\"" + model_.bodies[i].name + "\" and \"" + model_.bodies[k].name +
                               "\" touch with several materials: those of their first colliders are combined");
      }
      if (model_.pair_materials.size() == most) {
        doc_.source().warn(
            {}, "there are too many pairs of bodies to combine their materials; the average is taken for the rest");
        return;
      }
      sudar::Material m = a.values;
      m.friction_static = combined(friction, a.values.friction_static, b.values.friction_static);
      m.friction_dynamic = combined(friction, a.values.friction_dynamic, b.values.friction_dynamic);
      m.restitution = combined(bounce, a.values.restitution, b.values.restitution);
      model_.pair_materials.push_back({{body_number(i), body_number(k), m}, model_.bodies[i].from, ""});
    }
  }
}

}
