#include "io/mjcf/bodies.h"

#include <algorithm>
#include <utility>

#include "io/mjcf/contacts.h"
#include "io/mjcf/meshes.h"

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

// A file at work: the source's own, or one that it attaches.
struct Part {
  Part(Source& source, Remarks& remarks, const std::filesystem::path& path)
      : file(source, remarks, path),
        settings(mjcf_settings(file, remarks)),
        meshes(source, remarks, file, settings),
        contacts(remarks, file, settings) {}
  Part(Source& source, Remarks& remarks, const MjcfFile& own, const MjcfSettings& of_own)
      : file(own), settings(of_own), meshes(source, remarks, file, settings), contacts(remarks, file, settings) {}
  MjcfFile file;
  MjcfSettings settings;
  MjcfMeshes meshes;
  MjcfContacts contacts;
};

// Where the reader is.
struct Place {
  Part* part;
  std::string prefix{}, suffix{};  // of names
  std::string childclass{};
  int link = ground;
  Frame in_link{};  // of <frame>s and the like around
  std::string body = "world";
  std::size_t attached = 0;  // files in each other
};

class BodiesReader {
 public:
  BodiesReader(Source& source, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings)
      : source_(source), remarks_(remarks), part_(source, remarks, file, settings) {}

  MjcfBodies read() {
    out_.names.bodies["world"] = ground;
    for (const XmlElement& section : part_.file.root().children) {
      if (section.name == "worldbody") contents(section, {.part = &part_});
    }
    out_.mechanism.touching = part_.contacts.touching();
    if (const double total = part_.settings.total_mass; total > 0) scale_masses(total);
    return std::move(out_);
  }

 private:
  Link& link(int i) { return out_.mechanism.links[std::size_t(i)]; }
  std::string name_of(const XmlElement& e, const Place& place) const {
    const XmlAttribute* own = e.find("name");
    return own != nullptr && !own->value.empty() ? place.prefix + own->value + place.suffix : "";
  }
  template <class Table, class Value>
  void know(Table& table, const std::string& name, const Origin& at, Value value) {
    if (!name.empty() && !table.emplace(name, std::move(value)).second)
      throw FileError(at, "there are two elements of that name");
  }
  Fields fields(const XmlElement& e, const Place& place) { return place.part->file.fields(e, place.childclass); }

  int add_link(Link made, const XmlElement& e) {
    source_.count_item();
    made.from = e.at;
    out_.mechanism.links.push_back(std::move(made));
    return int(out_.mechanism.links.size()) - 1;
  }

  // What stands in <worldbody>, <body>, <frame> or <replicate>.
  void contents(const XmlElement& e, const Place& place) {
    for (const XmlElement& c : e.children) {
      if (c.name == "body")
        body(c, place);
      else if (c.name == "geom")
        geom(c, place);
      else if (c.name == "joint" || c.name == "freejoint")
        joint(c, place);
      else if (c.name == "site")
        site(c, place);
      else if (c.name == "frame")
        frame(c, place);
      else if (c.name == "replicate")
        replicate(c, place);
      else if (c.name == "attach")
        attach(c, place);
      else if (c.name != "inertial" && c.name != "camera" && c.name != "light")
        remarks_.warn({c.at.file, c.at.line, c.name}, in_quotes(c.name) + " is not supported, and left out");
    }
  }

  void body(const XmlElement& e, Place place) {
    const MjcfSettings& settings = place.part->settings;
    Fields f(remarks_, e);
    f.pass({"name", "user", "sleep"});
    if (e.find("childclass") != nullptr) place.childclass = f.text("childclass");
    if (!place.childclass.empty()) place.part->file.require_class(f.at("childclass"), place.childclass);
    Link made{.name = name_of(e, place), .parent = place.link, .at = place.in_link * placement(settings, f)};
    made.kinematic = f.flag("mocap", false);
    if (made.kinematic && place.link != ground) f.fail("mocap", "is for bodies of the world alone");
    made.gravity = 1 - f.number("gravcomp", 0);
    f.finish();
    place.body = made.name;
    place.link = add_link(std::move(made), e), place.in_link = {};
    know(out_.names.bodies, place.body, e.at, place.link);
    contents(e, place);
    weigh(e, place);
  }

  void frame(const XmlElement& e, Place place) {
    Fields f(remarks_, e);
    f.pass({"name"});
    if (e.find("childclass") != nullptr) place.childclass = f.text("childclass");
    place.in_link = place.in_link * placement(place.part->settings, f);
    f.finish();
    contents(e, place);
  }

  void replicate(const XmlElement& e, Place place) {
    Fields f(remarks_, e);
    const auto count = f.whole("count", 1, 1, 1'000'000);
    const std::string separator = f.text("sep");
    const Frame step{f.vector("offset"), orientation(place.part->settings, f)};
    f.finish();
    const std::size_t digits = std::to_string(count - 1).size();
    const std::string suffix = place.suffix;
    for (std::int64_t i = 0; i < count; ++i) {
      source_.count_item();
      const std::string number = std::to_string(i);
      place.suffix = separator + std::string(digits - number.size(), '0') + number + suffix;
      contents(e, place);
      place.in_link = place.in_link * step;
    }
  }

  void attach(const XmlElement& e, Place place) {
    Fields f(remarks_, e);
    const std::string model = f.text("model"), body_name = f.text("body");
    place.prefix += f.text("prefix");
    f.pass({"name"});
    f.finish();
    constexpr std::size_t deepest = 8;
    if (++place.attached > deepest)
      f.fail("model", "files are attached deeper in each other than " + std::to_string(deepest));
    place.part = part_of(e, model, *place.part);
    if (place.part == nullptr) return;
    place.childclass.clear();
    const XmlElement* root = nullptr;
    for (const XmlElement& section : place.part->file.root().children) {
      if (section.name != "worldbody") continue;
      if (body_name.empty())
        contents(section, place);
      else if (root == nullptr)
        root = find_body(section, body_name);
    }
    if (body_name.empty()) return;
    if (root == nullptr) f.fail("body", "the model has no body of that name");
    body(*root, place);
  }

  // The file of an asset <model>; null: it is not there.
  Part* part_of(const XmlElement& e, const std::string& model, const Part& outer) {
    const XmlElement* asset = nullptr;
    outer.file.each_in("asset", [&](const XmlElement& a) {
      const XmlAttribute* name = a.find("name");
      if (a.name == "model" && name != nullptr && name->value == model) asset = &a;
    });
    const XmlAttribute* file = asset != nullptr ? asset->find("file") : nullptr;
    if (file == nullptr) throw FileError(e.at, "there is no model " + in_quotes(model));
    std::filesystem::path path;
    try {
      path = source_.find(file->value, outer.file.path()).lexically_normal();
    } catch (const Error& error) {
      remarks_.warn(file->at, std::string("what is attached of it is left out: ") + error.what());
      return nullptr;
    }
    try {
      auto& part = attached_[path];
      if (part == nullptr) {
        part = std::make_unique<Part>(source_, remarks_, path);
        for (const char* section : {"tendon", "actuator", "equality", "contact"}) {
          part->file.each_in(section, [&](const XmlElement& s) {
            remarks_.warn(s.at,
                          "belongs to a model that is attached, and is left out: its bodies and joints alone are read");
          });
        }
      }
      return part.get();
    } catch (const FileError&) { throw; } catch (const Error& error) {
      throw FileError(file->at, error.what());
    }
  }

  static const XmlElement* find_body(const XmlElement& in, const std::string& name) {
    for (const XmlElement& c : in.children) {
      const XmlAttribute* own = c.find("name");
      if (c.name == "body" && own != nullptr && own->value == name) return &c;
      if (const XmlElement* inside = find_body(c, name)) return inside;
    }
    return nullptr;
  }

  void site(const XmlElement& e, const Place& place) {
    Fields f = fields(e, place);
    Frame at = placement(place.part->settings, f);
    if (const auto x = f.numbers("fromto", 6, 6); !x.empty()) at.p = Vec3d{x[0] + x[3], x[1] + x[4], x[2] + x[5]} * 0.5;
    f.pass({"name", "type", "group", "material", "size", "rgba", "user"});
    f.finish();
    know(out_.names.sites, name_of(e, place), e.at, MjcfNames::Place{place.link, place.in_link.point(at.p)});
  }

  void joint(const XmlElement& e, const Place& place);
  void geom(const XmlElement& e, const Place& place);
  Solid solid_of(Fields&, std::size_t type, const Place&, double half_length);
  void weigh(const XmlElement& body, const Place& place);
  void scale_masses(double total);

  Source& source_;
  Remarks& remarks_;
  Part part_;
  std::map<std::filesystem::path, std::unique_ptr<Part>> attached_;
  MjcfBodies out_;
};

constexpr const char* softness = "is of MuJoCo's soft constraints, and left out";

void BodiesReader::joint(const XmlElement& e, const Place& place) {
  if (place.link == ground) throw FileError(e.at, "stands in the world, which has no joints");
  const MjcfSettings& s = place.part->settings;
  Link& own = link(place.link);
  Fields f = e.name == "freejoint" ? Fields(remarks_, e) : fields(e, place);
  f.pass({"name", "group", "user", "align"});
  const std::size_t type = e.name == "freejoint" ? 3 : f.choice("type", 0, {"hinge", "slide", "ball", "free"});
  const std::string name = name_of(e, place);
  if (own.free || (type == 3 && !own.degrees.empty()))
    throw FileError(e.at, "a free joint must be the only one of its body");
  if (own.kinematic) throw FileError(e.at, "a body moved by mocap has no joints");
  source_.count_item();
  if (type == 3) {
    if (own.parent != ground) throw FileError(e.at, "a free joint is for bodies of the world alone");
    for (const char* passive : {"damping", "armature", "frictionloss", "stiffness"}) {
      if (f.number(passive, 0, not_negative) > 0) f.leave_out(passive, "of a free joint is not supported");
    }
    f.pass({"type", "pos", "axis", "range", "limited", "springref", "ref", "margin", "solreflimit", "solimplimit",
            "solreffriction", "solimpfriction", "actuatorfrcrange", "actuatorfrclimited", "actuatorgravcomp",
            "springdamper"});
    f.finish();
    own.free = true;
    return;
  }
  constexpr Freedom kinds[] = {Freedom::hinge, Freedom::slide, Freedom::ball};
  Degree d{.kind = kinds[type], .name = name, .from = e.at};
  const auto unit = [&](double x) { return d.kind == Freedom::slide ? x : angle(s, x); };
  d.at = place.in_link.point(f.vector("pos"));
  d.axis = rotate(place.in_link.q, f.direction("axis", {0, 0, 1}));
  const double reference = unit(f.number("ref", 0));
  const auto range = f.numbers("range", 2, 2);
  const std::size_t limited = f.choice("limited", 2, {"false", "true", "auto"});
  if (limited == 1 && range.empty()) f.fail("limited", "is true, but there is no range");
  const bool any_range = !range.empty() && range[0] != range[1];
  if (limited == 2 && any_range && !s.auto_limits)
    f.fail("range", "is given, but without \"limited\" nobody knows whether it counts");
  if (s.limits && (limited == 1 || (limited == 2 && any_range))) {
    if (range[0] > range[1]) f.fail("range", "ends below where it begins");
    d.range = {unit(range[0]) - reference, unit(range[1]) - reference};
  }
  const double stiffness = f.number("stiffness", 0, not_negative), damping = f.number("damping", 0, not_negative);
  const double rest = unit(f.number("springref", 0)) - reference;
  d.add({.stiffness = s.springs ? stiffness : 0, .rest = rest, .damping = s.dampers ? damping : 0});
  d.friction = s.friction ? f.number("frictionloss", 0, not_negative) : 0;
  d.armature = f.number("armature", 0, not_negative);
  if (f.has("springdamper")) f.leave_out("springdamper", "is not supported: give stiffness and damping");
  for (const char* soft : {"solreflimit", "solimplimit", "solreffriction", "solimpfriction"}) f.mention(soft, softness);
  f.pass({"frictionloss", "margin", "actuatorfrcrange", "actuatorfrclimited", "actuatorgravcomp"});
  f.finish();
  know(out_.names.joints, name, e.at, MjcfNames::Joint{place.link, own.degrees.size(), reference});
  own.degrees.push_back(std::move(d));
}

enum GeomType : std::size_t {
  plane,
  sphere_geom,
  capsule_geom,
  ellipsoid_geom,
  cylinder_geom,
  box_geom,
  mesh_geom,
  hfield,
  sdf
};

// The solid along z, its mass properties in the shape's frame.
Solid BodiesReader::solid_of(Fields& f, std::size_t type, const Place& place, double half_length) {
  constexpr std::size_t needed[] = {0, 1, 2, 3, 2, 3};
  const bool along = f.has("fromto");
  const auto given = f.numbers("size", 0, 3);
  std::size_t count = given.size();
  std::array<double, 3> size{};
  std::ranges::copy(given, size.begin());
  if (type == mesh_geom || f.has("mesh")) {
    if (!f.has("mesh")) f.fail("type", "is a mesh, but no mesh is named");
    if (type != mesh_geom) remarks_.warn(f.at("mesh"), "a geom that is fitted to a mesh is the mesh's hull here");
    return place.part->meshes.find(f.at("mesh"), f.text("mesh"));
  }
  if (type == plane) return {half_space(), {}};
  if (type == hfield || type == sdf) {
    remarks_.warn(f.at("type"), "a geom of this type is not supported, and left out");
    f.pass({"hfield", "plugin"});
    return {};
  }
  if (along) {  // the length is that between the two points
    if (type == sphere_geom) f.fail("fromto", "is for geoms that have a length");
    if (count == 0) f.fail("size", "is missing");
    const bool broad = type == ellipsoid_geom || type == box_geom;
    size[1] = size[0];
    size[broad ? 2 : 1] = half_length, count = 3;
  }
  if (count < needed[type]) f.fail("size", "needs " + std::to_string(needed[type]) + " numbers");
  for (std::size_t k = 0; k < needed[type]; ++k) {
    if (!(size[k] > 0)) f.fail("size", "must be positive");
  }
  const auto made = [&](Shape shape, const auto& solid) { return Solid{std::move(shape), mass_of(solid)}; };
  switch (type) {
    case sphere_geom:
      return made(sphere(Real(size[0])), solid::Sphere{size[0]});
    case capsule_geom:
      return made(capsule(Real(size[0]), Real(2 * size[1])), solid::Capsule{size[0], 2 * size[1]});
    case cylinder_geom:
      return made(cylinder(Real(size[0]), Real(2 * size[1])), solid::Cylinder{size[0], 2 * size[1]});
    // In the shape's frame y is along the geom's z, and z against its y.
    case ellipsoid_geom: {
      const Vec3d radii{size[0], size[2], size[1]};
      return made(ellipsoid(convert<Real>(radii)), solid::Ellipsoid{radii});
    }
    default: {
      const Vec3d edges{2 * size[0], 2 * size[2], 2 * size[1]};
      return made(box(convert<Real>(edges)), solid::Box{edges});
    }
  }
}

void BodiesReader::geom(const XmlElement& e, const Place& place) {
  const MjcfSettings& s = place.part->settings;
  Fields f = fields(e, place);
  const std::string name = name_of(e, place);
  const std::size_t type = f.choice(
      "type", sphere_geom, {"plane", "sphere", "capsule", "ellipsoid", "cylinder", "box", "mesh", "hfield", "sdf"});
  Frame at = placement(s, f);
  double half_length = 0;
  if (const auto x = f.numbers("fromto", 6, 6); !x.empty()) {
    const Vec3d from{x[0], x[1], x[2]}, to{x[3], x[4], x[5]};
    half_length = 0.5 * length(from - to);
    if (!(half_length > 1e-9)) f.fail("fromto", "has no length");
    at = {(from + to) * 0.5, turn_of_z(from - to)};
  }
  const auto friction = f.numbers("friction", 1, 3);
  const auto condim = f.whole("condim", 3, 1, 6);
  const auto contype = f.whole("contype", 1, 0, 0xffffffff), conaffinity = f.whole("conaffinity", 1, 0, 0xffffffff);
  const double group = f.number("group", 0), density = f.number("density", 1000, not_negative);
  const double given_mass = f.number("mass", -1, not_negative);
  f.pass({"name", "hfield", "mesh", "fitscale", "rgba", "material", "user", "fluidcoef", "plugin", "size"});
  if (f.whole("priority", 0, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()) != 0)
    f.leave_out("priority", "is not supported: of two frictions the larger counts");
  if (f.has("fluidshape")) f.pass({"fluidshape"});
  if (f.choice("shellinertia", 0, {"false", "true"}) == 1)
    f.leave_out("shellinertia", "is not supported: the geom weighs as a solid");
  for (const char* soft : {"solref", "solimp", "solmix", "margin", "gap"}) f.mention(soft, softness);

  Piece piece{.name = name, .from = e.at};
  try {
    Solid made = solid_of(f, type, place, half_length);
    piece.shape = std::move(made.shape), piece.unit = made.unit;
  } catch (const FileError&) { throw; } catch (const Error& error) {
    throw FileError(e.at, error.what());
  }
  f.finish();
  if (!piece.shape) return;
  source_.count_item();
  const bool along_y = type != mesh_geom && !f.has("mesh");
  piece.at = place.in_link * at * (along_y ? Frame{{}, turn_of_y_to_z()} : Frame{});
  if (type != plane && group >= s.first_group && group <= s.last_group)
    piece.mass = given_mass >= 0 ? given_mass : density * piece.unit.volume;
  const double sliding = condim > 1 ? (friction.empty() ? 1 : friction[0]) : 0;
  piece.material.friction_static = piece.material.friction_dynamic = Real(sliding);
  if (condim > 3) piece.material.spinning = Real(friction.size() > 1 ? friction[1] : 0.005);
  if (condim > 5) piece.material.rolling = Real(friction.size() > 2 ? friction[2] : 0.0001);
  piece.meets = part_.contacts.meets(e.at, std::uint32_t(contype), std::uint32_t(conaffinity), name, place.body);
  if (contype == 0 && conaffinity == 0 && s.drop_looks) piece.shape = {};
  if (place.link != ground) {
    link(place.link).pieces.push_back(std::move(piece));
    return;
  }
  if (!piece.shape) return;
  Link still{.name = name, .at = std::exchange(piece.at, Frame{})};
  still.pieces.push_back(std::move(piece));
  add_link(std::move(still), e);
}

void BodiesReader::weigh(const XmlElement& e, const Place& place) {
  const MjcfSettings& s = place.part->settings;
  Link& own = link(place.link);
  const XmlElement* given = e.child("inertial");
  if (given != nullptr && s.inertia != MjcfSettings::Inertia::from_geoms) {
    Fields f(remarks_, *given);
    const Frame at = placement(s, f);
    if (!f.has("mass")) f.fail("mass", "is missing");
    own.inertial.mass = f.number("mass", 0, not_negative);
    own.inertial.center = at.p;
    const auto diagonal = f.numbers("diaginertia", 3, 3), full = f.numbers("fullinertia", 6, 6);
    Mat3d tensor;
    if (!full.empty())
      tensor = {{full[0], full[3], full[4]}, {full[3], full[1], full[5]}, {full[4], full[5], full[2]}};
    else if (!diagonal.empty())
      tensor = Mat3d::diagonal({diagonal[0], diagonal[1], diagonal[2]});
    own.inertial.inertia = turned(tensor, at.q);
    f.finish();
  } else if (s.inertia != MjcfSettings::Inertia::given) {
    for (const Piece& p : own.pieces) {
      if (p.mass > 0 && p.unit.volume > 0)
        own.inertial = together(own.inertial, moved(inertial_of(p.unit, p.mass), p.at));
    }
  }
  std::erase_if(own.pieces, [](const Piece& p) { return !p.shape; });
  Inertial& i = own.inertial;
  i.mass = max(i.mass, s.least_mass);
  if (s.least_inertia > 0 && !at_least(i.inertia, s.least_inertia)) {
    const Mat3d d = i.inertia;
    if (d.c0.y != 0 || d.c0.z != 0 || d.c1.z != 0)
      remarks_.warn(e.at, "its inertia is made larger by boundinertia about the body's axes");
    for (int k = 0; k < 3; ++k) i.inertia[k][k] = max(d[k][k], s.least_inertia);
  }
  if (s.balance && !has_body(i.inertia)) i.inertia = Mat3d::identity() * (trace(i.inertia) / 3);
}

void BodiesReader::scale_masses(double total) {
  double sum = 0;
  for (const Link& l : out_.mechanism.links) sum += l.inertial.mass;
  if (!(sum > 0)) return;
  for (Link& l : out_.mechanism.links)
    l.inertial.mass *= total / sum, l.inertial.inertia = l.inertial.inertia * (total / sum);
}

}

MjcfBodies mjcf_bodies(Source& source, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings) {
  return BodiesReader(source, remarks, file, settings).read();
}

}
