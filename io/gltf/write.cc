#include "io/gltf/write.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* physics = "KHR_physics_rigid_bodies";

Json array(const auto& v) { return Json::array({double(v.x), double(v.y), double(v.z)}); }
Json rotation(const auto& q) { return Json::array({double(q.x), double(q.y), double(q.z), double(q.w)}); }

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? std::uint32_t(bytes[i + k]) : 0);
    for (std::size_t k = 0; k < 4; ++k) text += k <= bytes.size() - i ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

// A box's hull is told by its corners.
std::optional<Vec3> box_size(const Shape& shape) {
  const auto corners = shape.vertices();
  if (corners.size() != 8) return {};
  const Vec3 half = abs(corners.front());
  for (const Vec3& c : corners) {
    if (abs(c) != half) return {};
  }
  return half * 2;
}

bool is_usual(const Filter& f) { return f.category == Filter{}.category && f.mask == Filter{}.mask; }
bool has_filter(const BodyDef& def) {
  return !is_usual(def.filter) ||
         std::ranges::any_of(def.shapes, [](const ShapeDef& s) { return s.filter && !is_usual(*s.filter); });
}

class Writer {
 public:
  Writer(const Model& model, std::vector<Finding>& lost) : model_(model), lost_(lost) {
    root_["asset"] = {{"version", "2.0"}, {"generator", std::string("Sudar ") + SUDAR_VERSION}};
    root_["extensionsUsed"] = {"KHR_implicit_shapes", physics};
    root_["scene"] = 0;
    root_["scenes"] = Json::array({Json::object()});
    if (!model.name.empty()) root_["scenes"][0]["name"] = model.name;
    filtered_ = std::ranges::any_of(model.bodies, [](const Item<BodyDef>& b) { return has_filter(b.def); });
    for (std::size_t i = 0; i < model.bodies.size(); ++i) add_body(i);
    for (const JointItem& joint : model.joints) add_joint(joint);
    tell_lost();
    for (const char* name : {"physicsMaterials", "collisionFilters", "physicsJoints"}) {
      if (lists_.contains(name)) root_["extensions"][physics][name] = lists_[name];
    }
    if (lists_.contains("shapes")) root_["extensions"]["KHR_implicit_shapes"]["shapes"] = lists_["shapes"];
    root_["scenes"][0]["nodes"] = roots_;
    root_["nodes"] = nodes_;
    if (!meshes_.empty()) root_["meshes"] = meshes_, root_["accessors"] = accessors_, root_["bufferViews"] = views_;
  }

  Bytes text() {
    if (!buffer_.empty()) {
      root_["buffers"] = {
          {{"byteLength", buffer_.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer_)}}};
    }
    const std::string text = root_.dump(1) + "\n";
    const auto* first = reinterpret_cast<const std::byte*>(text.data());
    return {first, first + text.size()};
  }

  Bytes binary() {
    if (!buffer_.empty()) root_["buffers"] = {{{"byteLength", buffer_.size()}}};
    std::string json = root_.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    buffer_.resize((buffer_.size() + 3) / 4 * 4);
    Bytes all;
    const auto word = [&](std::size_t w) {
      for (int i = 0; i < 4; ++i) all.push_back(std::byte(w >> (8 * i) & 255));
    };
    word(0x46546c67), word(2), word(20 + json.size() + (buffer_.empty() ? 0 : 8 + buffer_.size()));
    word(json.size()), word(0x4e4f534a);
    const auto* first = reinterpret_cast<const std::byte*>(json.data());
    all.insert(all.end(), first, first + json.size());
    if (buffer_.empty()) return all;
    word(buffer_.size()), word(0x004e4942);
    all.insert(all.end(), buffer_.begin(), buffer_.end());
    return all;
  }

 private:
  void lose(const Origin& from, std::string what) { lost_.push_back({Severity::warning, from, std::move(what)}); }

  // The number of an entry in a list of definitions, each of which is there once.
  std::size_t number_of(const char* list, const Json& entry) {
    Json& entries = lists_[list];
    const auto it = std::ranges::find(entries, entry);
    const std::size_t number = std::size_t(it - entries.begin());
    if (it == entries.end()) entries.push_back(entry);
    return number;
  }
  std::size_t add_node(Json node) {
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  Json material(const Material& m) const {
    static constexpr const char* modes[] = {"minimum", "average", "average", "maximum"};  // by Mix; geometric is lost
    Json j{{"staticFriction", double(m.friction_static)},
           {"dynamicFriction", double(m.friction_dynamic)},
           {"restitution", double(m.restitution)}};
    j["frictionCombine"] = modes[std::size_t(model_.config.friction_mix)];
    j["restitutionCombine"] = modes[std::size_t(model_.config.restitution_mix)];
    return j;
  }

  Json filter(const Filter& f) const {
    const auto systems = [](std::uint32_t bits) {
      Json list = Json::array();
      for (int i = 0; i < 32; ++i) {
        if (bits >> i & 1) list.push_back(std::to_string(i));
      }
      return list;
    };
    return {{"collisionSystems", systems(f.category)}, {"collideWithSystems", systems(f.mask)}};
  }

  std::size_t add_mesh(const std::vector<Vec3>& vertices, const std::vector<std::uint32_t>& triangles) {
    const auto view = [&](const void* data, std::size_t size) {
      views_.push_back({{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", size}});
      const auto* first = static_cast<const std::byte*>(data);
      buffer_.insert(buffer_.end(), first, first + size);
      return views_.size() - 1;
    };
    std::vector<float> xyz;
    Vec3T<float> low = convert<float>(vertices.front()), high = low;
    for (const Vec3& v : vertices) {
      const Vec3T<float> f = convert<float>(v);
      xyz.insert(xyz.end(), {f.x, f.y, f.z});
      low = min(low, f), high = max(high, f);
    }
    accessors_.push_back({{"bufferView", view(xyz.data(), xyz.size() * sizeof(float))},
                          {"componentType", 5126},
                          {"count", vertices.size()},
                          {"type", "VEC3"},
                          {"min", array(low)},
                          {"max", array(high)}});
    accessors_.push_back({{"bufferView", view(triangles.data(), triangles.size() * sizeof(std::uint32_t))},
                          {"componentType", 5125},
                          {"count", triangles.size()},
                          {"type", "SCALAR"}});
    meshes_.push_back(
        {{"primitives",
          {{{"attributes", {{"POSITION", accessors_.size() - 2}}}, {"indices", accessors_.size() - 1}}}}});
    return meshes_.size() - 1;
  }

  Json implicit(const char* type, Json own) {
    return {{"shape", number_of("shapes", {{"type", type}, {type, std::move(own)}})}};
  }

  // The geometry of a shape, for a node at `at`, which it may move or scale; null: it has none.
  Json geometry(const Shape& shape, Transform& at, Json& node, const Origin& from) {
    const double r = double(shape.radius()), h = 2 * double(shape.half_length());
    switch (shape.kind()) {
      case ShapeKind::sphere:
        return implicit("sphere", {{"radius", r}});
      case ShapeKind::capsule:
        return implicit("capsule", {{"radiusTop", r}, {"radiusBottom", r}, {"height", h}});
      case ShapeKind::cylinder:
        return implicit("cylinder", {{"radiusTop", r}, {"radiusBottom", r}, {"height", h}});
      case ShapeKind::cone:  // its own origin is the centre of mass
        at.p = at.point({0, Real(h / 4), 0});
        return implicit("cylinder", {{"radiusTop", 0.0}, {"radiusBottom", r}, {"height", h}});
      case ShapeKind::ellipsoid:
        node["scale"] = array(shape.radii());
        return implicit("sphere", {{"radius", 1.0}});
      case ShapeKind::half_space:
        return implicit("plane", Json::object());
      case ShapeKind::hollow_sphere:
      case ShapeKind::hollow_cylinder:
        lose(from, "a hollow has no place in glTF; left out");
        return nullptr;
      case ShapeKind::hull:
        if (const auto size = box_size(shape)) return implicit("box", {{"size", array(*size)}});
        [[fallthrough]];
      case ShapeKind::mesh:
        break;
    }
    const std::vector<Vec3> vertices(shape.vertices().begin(), shape.vertices().end());
    std::vector<std::uint32_t> triangles;
    for (const auto& face : shape.faces()) {
      for (std::size_t k = 1; k + 1 < face.size(); ++k)
        triangles.insert(triangles.end(), {face[0], face[k], face[k + 1]});
    }
    const std::size_t mesh = add_mesh(vertices, triangles);
    node["mesh"] = mesh;
    // The geometry is a node's; one outside the scene, so that it is not there twice.
    return {{"node", add_node({{"mesh", mesh}})}, {"convexHull", shape.kind() == ShapeKind::hull}};
  }

  void add_body(std::size_t i) {
    const BodyDef& def = model_.bodies[i].def;
    const Origin& from = model_.bodies[i].from;
    const std::size_t number = add_node(Json::object());
    roots_.push_back(number), body_nodes_.push_back(number);
    Json node = Json::object();
    if (!def.name.empty()) node["name"] = def.name;
    node["translation"] = array(def.at), node["rotation"] = rotation(normalize(def.turn));
    Json children = Json::array();
    std::vector<ShapeDef> parts = def.shapes;
    if (def.shape) parts.push_back({.shape = def.shape});
    for (const ShapeDef& part : parts) {
      Transform at{part.at, normalize(part.turn)};
      Json child = Json::object();
      const Json shape = geometry(part.shape, at, child, from);
      if (shape.is_null()) continue;
      Json collider{{"geometry", shape},
                    {"physicsMaterial", number_of("physicsMaterials", material(part.material.value_or(def.material)))}};
      const Filter f = part.filter.value_or(def.filter);
      if (filtered_) collider["collisionFilter"] = number_of("collisionFilters", filter(f));
      if (f.group != 0) lose(from, "a filter's group has no place in glTF; left out");
      child["translation"] = array(at.p), child["rotation"] = rotation(at.q);
      child["extensions"][physics]["collider"] = collider;
      children.push_back(add_node(child));
    }
    if (def.motion != Motion::fixed) node["extensions"][physics]["motion"] = motion(def, parts);
    if (!children.empty()) node["children"] = children;
    nodes_[number] = node;
  }

  Json motion(const BodyDef& def, const std::vector<ShapeDef>& parts) {
    Json m = Json::object();
    if (def.motion == Motion::kinematic)
      m["isKinematic"] = true;
    else
      describe_mass(m, def, parts);
    if (def.velocity != Vec3{}) m["linearVelocity"] = array(rotate_back(normalize(def.turn), def.velocity));
    if (def.spin != Vec3{}) m["angularVelocity"] = array(rotate_back(normalize(def.turn), def.spin));
    if (def.gravity_factor != 1) m["gravityFactor"] = double(def.gravity_factor);
    return m;
  }

  // As a world finds it: densities have no place in glTF.
  void describe_mass(Json& m, const BodyDef& def, const std::vector<ShapeDef>& parts) {
    World trial;
    BodyDef at_rest = def;
    at_rest.at = {}, at_rest.turn = {}, at_rest.velocity = at_rest.spin = {};
    const BodyView body = trial[trial.add(at_rest)];
    m["mass"] = double(body.mass());
    if (!def.center && !def.inertia && parts.size() == 1 && !parts.front().density) return;
    m["centerOfMass"] = array(body.center());
    const Mat3 tensor = body.inertia();
    const auto [moments, axes] =
        principal_axes({convert<double>(tensor.c0), convert<double>(tensor.c1), convert<double>(tensor.c2)});
    m["inertiaDiagonal"] = array(moments), m["inertiaOrientation"] = rotation(axes);
  }

  // By rotations that each make one pair of entries zero (C. Jacobi 1846).
  static std::pair<Vec3d, Quatd> principal_axes(Mat3d a) {
    Mat3d v = Mat3d::identity();
    for (int sweep = 0; sweep < 30; ++sweep) {
      for (const auto& [p, q] : {std::pair{0, 1}, {0, 2}, {1, 2}}) {
        if (abs(a[q][p]) <= 1e-15 * trace(a)) continue;
        const double angle = 0.5 * atan2(2 * a[q][p], a[q][q] - a[p][p]), c = cos(angle), s = sin(angle);
        Mat3d r = Mat3d::identity();
        r[p][p] = c, r[q][q] = c, r[p][q] = -s, r[q][p] = s;
        a = transpose(r) * a * r, v = v * r;
      }
    }
    if (determinant(v) < 0) v.c2 = -v.c2;
    return {{a.c0.x, a.c1.y, a.c2.z}, quaternion(v)};
  }

  // --- joints ---

  struct Ends {
    Body a, b;
    bool collide = false;
    Pos at_a, at_b;
    Vec3 axis{1, 0, 0};
  };
  static constexpr const char* linear = "linearAxes";
  static constexpr const char* angular = "angularAxes";
  static Json limit(const char* kind, std::vector<int> axes, double low, double high) {
    Json l{{kind, axes}};
    if (low > -infinite) l["min"] = low;
    if (high < infinite) l["max"] = high;
    return l;
  }
  static Json lock(const char* kind, std::vector<int> axes) { return limit(kind, std::move(axes), 0, 0); }

  // Limits in a frame whose x is the joint's axis; null: no place in glTF.
  static Json limits_of(const JointDef& def) {
    const Json ways = lock(linear, {0, 1, 2}), turns = lock(angular, {0, 1, 2});
    if (std::get_if<Fixed>(&def)) return {ways, turns};
    if (std::get_if<Ball>(&def)) return Json::array({ways});
    if (std::get_if<Plane>(&def)) return Json::array({lock(linear, {0})});
    if (const auto* h = std::get_if<Hinge>(&def)) {
      return {ways, lock(angular, {1, 2}), limit(angular, {0}, double(h->limit.low), double(h->limit.high))};
    }
    if (const auto* s = std::get_if<Slider>(&def)) {
      return {turns, lock(linear, {1, 2}), limit(linear, {0}, double(s->limit.low), double(s->limit.high))};
    }
    if (const auto* r = std::get_if<Rope>(&def)) {
      return Json::array({limit(linear, {0, 1, 2}, 0, double(r->length > 0 ? r->length : length(r->at_a - r->at_b)))});
    }
    return nullptr;
  }

  static Ends ends_of(const JointDef& def) {
    return std::visit(
        [](const auto& d) {
          Ends e{d.a, d.b, d.collide, {}, {}};
          if constexpr (requires { d.at_a; }) e.at_a = d.at_a;
          if constexpr (requires { d.at_b; }) e.at_b = d.at_b;
          if constexpr (
              requires { d.at; } && !requires { d.at_a; })
            e.at_a = e.at_b = d.at;
          if constexpr (requires { d.axis; }) e.axis = d.axis;
          if constexpr (requires { d.normal; }) e.axis = d.normal;
          return e;
        },
        def);
  }

  // A joint's frame as a node on its body.
  std::size_t attach(Body body, const Pos& at, const Quat& turn, const std::optional<JointItem::Place>& moved) {
    Json node = Json::object();
    if (body.null()) {
      node["translation"] = array(at), node["rotation"] = rotation(turn);
      const std::size_t number = add_node(node);
      roots_.push_back(number);
      return number;
    }
    const BodyDef& def = model_.bodies[body.index].def;
    const Pose pose = moved && moved->body == body ? moved->at : Pose{def.at, normalize(def.turn)};
    node["translation"] = array(pose.local(at)), node["rotation"] = rotation(conjugate(pose.q) * turn);
    const std::size_t number = add_node(node);
    nodes_[body_nodes_[body.index]]["children"].push_back(number);
    return number;
  }

  void add_joint(const JointItem& item) {
    const Json limits = limits_of(item.def);
    if (limits.is_null()) return lose(item.from, "a joint of this kind has no place in glTF; left out");
    Json description{{"limits", limits}};
    const bool slides = std::holds_alternative<Slider>(item.def);
    std::visit(
        [&](const auto& d) {
          if constexpr (requires { d.drive; }) add_drive(description, d.drive, slides, item.from);
        },
        item.def);
    const Ends ends = ends_of(item.def);
    const Vec3 x = normalize(ends.axis), y = any_perpendicular(x);
    const Quat turn = quaternion(Mat3{x, y, cross(x, y)});
    const std::size_t a = attach(ends.a, ends.at_a, turn, item.made_at),
                      b = attach(ends.b, ends.at_b, turn, item.made_at);
    Json joint{{"connectedNode", b}, {"joint", number_of("physicsJoints", description)}};
    if (ends.collide) joint["enableCollision"] = true;
    nodes_[a]["extensions"][physics]["joint"] = joint;
  }

  void add_drive(Json& description, const Drive& d, bool linear, const Origin& from) {
    if (d.mode == DriveMode::off) return;
    if (d.mode != DriveMode::spring)
      return lose(from, "a motor or servo has no place in glTF, whose drives are springs; left out");
    Json drive{{"type", linear ? "linear" : "angular"},
               {"mode", "force"},
               {"axis", 0},
               {"positionTarget", double(d.target)},
               {"velocityTarget", double(d.rate)},
               {"stiffness", double(d.stiffness)},
               {"damping", double(d.damping)}};
    if (std::isfinite(d.force)) drive["maxForce"] = double(d.force);
    description["drives"] = Json::array({drive});
  }

  void tell_lost() {
    if (model_.config.friction_mix == Mix::geometric || model_.config.restitution_mix == Mix::geometric) {
      lose({}, "the geometric mean of materials has no place in glTF; written as their average");
    }
    if (!model_.pair_materials.empty()) lose({}, "materials of pairs of bodies have no place in glTF; left out");
    for (const auto& force : model_.forces) {
      const auto* g = std::get_if<Gravity>(&force.def);
      if (g == nullptr || g->acceleration != Gravity{}.acceleration)
        lose(force.from, "a force other than the earth's gravity has no place in glTF; left out");
    }
  }

  const Model& model_;
  std::vector<Finding>& lost_;
  Json root_, roots_ = Json::array(), nodes_ = Json::array(), meshes_ = Json::array(), accessors_ = Json::array(),
              views_ = Json::array();
  std::map<std::string, Json> lists_;
  std::vector<std::size_t> body_nodes_;
  Bytes buffer_;
  bool filtered_ = false;  // some body has a filter: then all need one
};

}

Bytes write_gltf(const Model& model, bool binary, std::vector<Finding>& lost) {
  Writer writer(model, lost);
  return binary ? writer.binary() : writer.text();
}

}
