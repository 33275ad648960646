#include "io/urdf.h"

#include <algorithm>
#include <set>

#include "io/articulation.h"
#include "io/solid.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

namespace fs = std::filesystem;

// Turns about the axes that stay, x first: roll, pitch, yaw.
Quatd turn_of_rpy(const Vec3d& rpy) {
  return normalize(axis_angle(Vec3d{0, 0, 1}, rpy.z) * axis_angle(Vec3d{0, 1, 0}, rpy.y) *
                   axis_angle(Vec3d{1, 0, 0}, rpy.x));
}

class UrdfReader {
 public:
  explicit UrdfReader(Source& source) : source_(source), remarks_(source) {}

  Model read() {
    const XmlElement root = parse_xml(source_, source_.text(), source_.file().string());
    if (root.name != "robot")
      throw FileError(root.at, "is no URDF: its root is " + in_quotes(root.name) + ", not \"robot\"");
    refuse_macros(root);
    Model model;
    if (const XmlAttribute* name = root.find("name")) model.name = name->value;
    for (const XmlElement& e : root.children) {
      if (e.name == "link")
        link(e);
      else if (e.name == "joint")
        joints_.push_back(&e);
      else if (e.name == "transmission" || e.name == "gazebo" || e.name == "ros2_control")
        remarks_.note({e.at.file, e.at.line, e.name}, in_quotes(e.name) + " is of other programs, and left out");
      else if (e.name != "material")
        remarks_.warn({e.at.file, e.at.line, e.name}, in_quotes(e.name) + " is not known, and left out");
    }
    if (links_.empty()) throw FileError(root.at, "has no link");
    for (const XmlElement* e : joints_) joint(*e);
    model.forces.push_back({Gravity{}, root.at, {}});
    Assembly(in_order(), model, source_, remarks_);
    remarks_.tell();
    return model;
  }

 private:
  static void refuse_macros(const XmlElement& e) {
    if (e.name.starts_with("xacro:"))
      throw FileError(e.at,
                      "is xacro, a language of macros that makes URDF: run \"xacro FILE > robot.urdf\" and open that");
    for (const XmlElement& c : e.children) refuse_macros(c);
  }

  const XmlElement& needed(const XmlElement& e, const char* child) {
    const XmlElement* found = e.child(child);
    if (found == nullptr) throw FileError(e.at, std::string("needs an element \"") + child + "\"");
    return *found;
  }
  void expect(const XmlElement& e, std::initializer_list<std::string_view> known) {
    for (const XmlElement& c : e.children) {
      if (std::ranges::find(known, c.name) == known.end())
        remarks_.warn({c.at.file, c.at.line, c.name},
                      in_quotes(c.name) + " in " + in_quotes(e.name) + " is not known, and left out");
    }
  }

  Frame origin(const XmlElement& e) {
    const XmlElement* found = e.child("origin");
    if (found == nullptr) return {};
    Fields f(remarks_, *found);
    const Frame at{f.vector("xyz"), turn_of_rpy(f.vector("rpy"))};
    f.finish();
    return at;
  }

  void link(const XmlElement& e) {
    Fields f(remarks_, e);
    f.pass({"type"});
    Link made{.name = f.text("name"), .from = e.at};
    if (made.name.empty()) f.fail("name", "is missing");
    f.finish();
    expect(e, {"inertial", "visual", "collision", "self_collision_checking", "contact"});
    if (!numbers_.emplace(made.name, links_.size()).second) throw FileError(e.at, "there are two links of that name");
    source_.count_item();
    if (const XmlElement* i = e.child("inertial")) made.inertial = inertial(*i);
    const bool collides =
        e.child("collision") != nullptr;  // else it is seen by what is drawn of it, which touches nothing
    for (const XmlElement& c : e.children) {
      if (c.name == (collides ? "collision" : "visual")) piece(c, made, collides);
    }
    links_.push_back(std::move(made));
  }

  Inertial inertial(const XmlElement& e) {
    expect(e, {"origin", "mass", "inertia"});
    const Frame at = origin(e);
    Fields mass(remarks_, needed(e, "mass"));
    if (!mass.has("value")) mass.fail("value", "is missing");
    Inertial i{.mass = mass.number("value", 0, not_negative)};
    mass.finish();
    const XmlElement* tensor = e.child("inertia");
    if (tensor == nullptr) return moved(i, at);
    Fields f(remarks_, *tensor);
    const auto n = [&](const char* name) { return f.number(name, 0); };
    i.inertia = {{n("ixx"), n("ixy"), n("ixz")}, {n("ixy"), n("iyy"), n("iyz")}, {n("ixz"), n("iyz"), n("izz")}};
    f.finish();
    return moved(i, at);
  }

  void piece(const XmlElement& e, Link& to, bool collides) {
    Fields f(remarks_, e);
    Piece made{.name = f.text("name"), .from = e.at, .meets = collides ? 0u : 1u};
    f.pass({"group"});
    f.finish();
    expect(e, {"origin", "geometry", "material", "verbose", "contact_coefficients"});
    const XmlElement& geometry = needed(e, "geometry");
    if (geometry.children.empty()) throw FileError(geometry.at, "is empty");
    Solid solid;
    bool along_z = false;
    try {
      solid = solid_of(geometry.children[0], along_z);
    } catch (const FileError&) { throw; } catch (const Error& error) {
      throw FileError(geometry.children[0].at, error.what());
    }
    if (!solid.shape) return;
    made.shape = std::move(solid.shape), made.unit = solid.unit;
    made.at = origin(e) * (along_z ? Frame{{}, turn_of_y_to_z()} : Frame{});
    to.pieces.push_back(std::move(made));
  }

  Solid solid_of(const XmlElement& e, bool& along_z) {
    Fields f(remarks_, e);
    const auto size = [&](const char* name) {
      if (!f.has(name)) f.fail(name, "is missing");
      return f.number(name, 0, positive);
    };
    Solid made;
    if (e.name == "box") {
      const Vec3d edges = f.vector("size");
      if (!(edges.x > 0 && edges.y > 0 && edges.z > 0)) f.fail("size", "must be three positive numbers");
      made = {box(convert<Real>(edges)), mass_of(solid::Box{edges})};
    } else if (e.name == "sphere") {
      const double radius = size("radius");
      made = {sphere(Real(radius)), mass_of(solid::Sphere{radius})};
    } else if (e.name == "cylinder" || e.name == "capsule") {
      const double radius = size("radius"), length = size("length");
      along_z = true;
      if (e.name == "cylinder")
        made = {cylinder(Real(radius), Real(length)), mass_of(solid::Cylinder{radius, length})};
      else
        made = {capsule(Real(radius), Real(length)), mass_of(solid::Capsule{radius, length})};
    } else if (e.name == "mesh") {
      made = mesh(e, f);
    } else {
      remarks_.warn(e.at, in_quotes(e.name) + " is no geometry that is known, and left out");
      return {};
    }
    f.finish();
    return made;
  }

  Solid mesh(const XmlElement& e, Fields& f) {
    const Vec3d factors = f.vector("scale", {1, 1, 1});
    const std::string name = f.text("filename");
    if (name.empty()) f.fail("filename", "is missing");
    try {
      if (!surfaces_.contains(name)) surfaces_[name] = read_surface(source_, located(name), source_.file());
      Surface scaled = surfaces_.at(name);
      for (Vec3d& v : scaled.vertices) v = scale(v, factors);
      if (factors.x * factors.y * factors.z < 0) {  // a mirror turns the surface inside out
        for (std::size_t i = 0; i + 2 < scaled.triangles.size(); i += 3)
          std::swap(scaled.triangles[i], scaled.triangles[i + 1]);
      }
      return io::solid_of(scaled, e.at, remarks_);
    } catch (const Error& error) {
      remarks_.warn(f.at("filename"), "the mesh " + in_quotes(name) + " is left out: " + error.what());
      return {};
    }
  }

  // package://NAME/… lies in the folder of that name on the way up from the file or in one that is allowed; else in the
  // nearest one that is a package, whatever it is called.
  std::string located(const std::string& name) const {
    constexpr std::string_view package = "package://", file = "file://";
    if (name.starts_with(file)) return name.substr(file.size());
    if (!name.starts_with(package)) return name;
    const std::string rest = name.substr(package.size());
    const std::size_t slash = rest.find('/');
    if (slash == std::string::npos || slash == 0) throw Error("", "names no file of a package");
    const std::string own = rest.substr(0, slash), inside = rest.substr(slash + 1);
    std::vector<fs::path> starts;
    std::error_code error;
    for (fs::path up = fs::weakly_canonical(source_.file(), error).parent_path(); !up.empty(); up = up.parent_path()) {
      starts.push_back(up);
      if (up == up.parent_path()) break;
    }
    for (const fs::path& folder : source_.options().allow) starts.push_back(fs::weakly_canonical(folder, error));
    for (const fs::path& folder : starts) {
      if (folder.filename() == own) return (folder / inside).string();
      if (fs::is_directory(folder / own, error)) return (folder / own / inside).string();
    }
    for (const fs::path& folder : starts) {
      if (fs::exists(folder / "package.xml", error)) return (folder / inside).string();
    }
    throw Error("",
                "there is no package " + in_quotes(own) + " in a folder above the file, or in one that --allow names");
  }

  void joint(const XmlElement& e);
  void degrees_of(const XmlElement& e, const std::string& type, Link& child);
  Articulation in_order();
  // Whether the link has a mass, with all that is fixed to it.
  bool is_heavy(std::size_t link, const std::vector<std::vector<std::size_t>>& children) const {
    std::vector<std::size_t> parts{link};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (links_[parts[k]].inertial.mass > 0) return true;
      for (const std::size_t c : children[parts[k]]) {
        if (links_[c].degrees.empty() && !links_[c].free) parts.push_back(c);
      }
    }
    return false;
  }

  Source& source_;
  Remarks remarks_;
  std::vector<Link> links_;
  std::map<std::string, std::size_t> numbers_;  // by name
  std::vector<const XmlElement*> joints_;
  std::set<std::string> joint_names_;
  std::map<std::string, Surface> surfaces_;
};

void UrdfReader::joint(const XmlElement& e) {
  Fields f(remarks_, e);
  const std::string name = f.text("name"), type = f.text("type");
  if (name.empty()) f.fail("name", "is missing");
  f.finish();
  if (!joint_names_.insert(name).second) throw FileError(e.at, "there are two joints of that name");
  expect(e, {"parent", "child", "origin", "axis", "limit", "dynamics", "mimic", "safety_controller", "calibration",
             "hardwareInterface"});
  const auto end = [&](const char* which) {
    Fields of_end(remarks_, needed(e, which));
    const std::string link = of_end.text("link");
    of_end.finish();
    const auto it = numbers_.find(link);
    if (it == numbers_.end()) of_end.fail("link", "there is no link " + in_quotes(link));
    return it->second;
  };
  const std::size_t parent = end("parent");
  Link& child = links_[end("child")];
  if (child.parent != ground) throw FileError(e.at, "is the second joint that holds the link " + in_quotes(child.name));
  child.parent = int(parent);
  child.at = origin(e);
  if (type == "floating")
    child.free = true;
  else if (type != "fixed")
    degrees_of(e, type, child);
}

void UrdfReader::degrees_of(const XmlElement& e, const std::string& type, Link& child) {
  Degree d{.name = e.find("name")->value, .from = e.at, .axis = {1, 0, 0}};
  if (const XmlElement* axis = e.child("axis")) {
    Fields f(remarks_, *axis);
    d.axis = f.direction("xyz", d.axis);
    f.pass({"rpy"});
    f.finish();
  }
  if (type == "planar") {
    const Vec3d across = any_perpendicular(d.axis);
    for (const Vec3d& way : {across, cross(d.axis, across)})
      child.degrees.push_back({Freedom::slide, d.name, d.from, {}, way});
    child.degrees.push_back(d);
    return;
  }
  if (type != "revolute" && type != "continuous" && type != "prismatic")
    throw FileError(
        e.find("type") != nullptr ? e.find("type")->at : e.at,
        "is of the type " + in_quotes(type) + ", must be revolute, continuous, prismatic, fixed, floating or planar");
  if (type == "prismatic") d.kind = Freedom::slide;
  if (const XmlElement* limit = e.child("limit")) {
    Fields f(remarks_, *limit);
    const double lower = f.number("lower", 0), upper = f.number("upper", 0);
    if (lower > upper) f.fail("upper", "is less than lower");
    if (type != "continuous") {
      d.range = {lower, upper};
      if (lower == upper) remarks_.note(limit->at, "its lower and upper end are the same: the joint cannot move");
    }
    f.pass({"effort", "velocity", "acceleration", "deceleration", "jerk"});  // of whoever drives it: it is not driven
    f.finish();
  } else if (type != "continuous") {
    throw FileError(e.at, "needs an element \"limit\"");
  }
  if (const XmlElement* dynamics = e.child("dynamics")) {
    Fields f(remarks_, *dynamics);
    d.add({.damping = f.number("damping", 0, not_negative)});
    d.friction = f.number("friction", 0, not_negative);
    f.finish();
  }
  if (const XmlElement* mimic = e.child("mimic"))
    remarks_.warn(mimic->at, "follows another joint, which is not supported: it moves by itself");
  child.degrees.push_back(std::move(d));
}

// Parents first; refuses what is no tree.
Articulation UrdfReader::in_order() {
  std::vector<std::vector<std::size_t>> children(links_.size());
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < links_.size(); ++i) {
    if (links_[i].parent != ground)
      children[std::size_t(links_[i].parent)].push_back(i);
    else if (order.empty())
      order.push_back(i);
    else
      throw FileError(links_[i].from,
                      "is a second root, beside " + in_quotes(links_[order[0]].name) + ": no joint holds it");
  }
  if (order.empty()) throw FileError(links_[0].from, "the links go round in a circle: none is the root");
  for (std::size_t k = 0; k < order.size(); ++k)
    order.insert(order.end(), children[order[k]].begin(), children[order[k]].end());
  if (order.size() < links_.size()) {
    std::vector<bool> reached(links_.size());
    for (const std::size_t i : order) reached[i] = true;
    const auto lost = std::size_t(std::ranges::find(reached, false) - reached.begin());
    throw FileError(links_[lost].from, "hangs on a circle of links, not on the root");
  }
  Link& root = links_[order[0]];
  root.free = root.name != "world" && is_heavy(order[0], children);
  remarks_.note(root.from, root.free
                               ? "is the root, and moves freely: one that is called \"world\" would stay where it is"
                               : "is the root, and stays where it is");
  Articulation result;
  std::vector<int> place(links_.size());
  for (const std::size_t i : order) {
    Link& l = links_[i];
    if (l.parent != ground) l.parent = place[std::size_t(l.parent)];
    place[i] = int(result.links.size());
    result.links.push_back(std::move(l));
  }
  result.touching = {{true, false}, {false, false}};
  return result;
}

}

Model read_urdf(Source& source) { return UrdfReader(source).read(); }

Model read_xacro(Source&) {
  throw Error("", "is xacro, a language of macros that makes URDF: run \"xacro FILE > robot.urdf\" and open that");
}

}
