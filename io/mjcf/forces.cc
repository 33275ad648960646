#include "io/mjcf/forces.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr const char* soft[] = {"solref",         "solimp",         "solreflimit", "solimplimit",
                                "solreffriction", "solimpfriction", "margin"};
void leave_softness(Fields& f) {
  for (const char* name : soft) f.mention(name, "is of MuJoCo's soft constraints, and left out");
}

template <class T>
const T& find(const MjcfNames::Table<T>& table, Fields& f, const char* attribute, const char* kind) {
  const std::string name = f.text(attribute);
  const auto it = table.find(name);
  if (it == table.end()) f.fail(attribute, std::string("there is no ") + kind + " " + in_quotes(name));
  return it->second;
}

// A limit that is on: "true", or a range where limits may be guessed.
bool is_limited(Fields& f, const MjcfSettings& s, const char* limited, const char* range) {
  const std::size_t given = f.choice(limited, 2, {"false", "true", "auto"});
  const auto numbers = f.numbers(range, 2, 2);
  if (given == 1 && numbers.empty()) f.fail(limited, std::string("is true, but there is no ") + range);
  return given == 1 || (given == 2 && !numbers.empty() && s.auto_limits);
}

// F = −stiffness (length − rest) − damping (its rate − rate), but no more than `most` [N or N m].
struct Pull {
  double stiffness = 0, rest = 0, damping = 0, rate = 0, most = infinite;
};

// A length that is `ratio` times the coordinate of a joint as MuJoCo counts it; of several that are added up in a fixed
// tendon, one.
struct Term {
  Degree* degree;
  double reference;  // MuJoCo's coordinate where that of the degree is 0
  double ratio;

  double coordinate(double length) const { return length / ratio - reference; }
  void add(const Pull& p) const {
    degree->add({.stiffness = p.stiffness * square(ratio),
                 .rest = coordinate(p.rest),
                 .damping = p.damping * square(ratio),
                 .rate = p.rate / ratio,
                 .force = p.most * abs(ratio)});
  }
};
using Tendons = std::map<std::string, std::vector<Term>>;

class JointForces {
 public:
  JointForces(MjcfBodies& bodies, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings)
      : bodies_(bodies), remarks_(remarks), file_(file), settings_(settings) {}

  void add() {
    file_.each_in("tendon", [&](const XmlElement& e) {
      if (e.name == "fixed") tendon(e);
    });
    file_.each_in("equality", [&](const XmlElement& e) {
      if (e.name == "joint" && settings_.equalities) equality(e);
    });
    file_.each_in("actuator", [&](const XmlElement& e) { actuator(e); });
  }

 private:
  Term joint(Fields& f, const char* attribute, double ratio = 1) {
    const MjcfNames::Joint& j = find(bodies_.names.joints, f, attribute, "joint");
    return {&bodies_.mechanism.links[std::size_t(j.link)].degrees[j.degree], j.reference, ratio};
  }

  void tendon(const XmlElement& e) {
    Fields f = file_.fields(e);
    const std::string name = f.text("name");
    std::vector<Term> terms;
    for (const XmlElement& c : e.children) {
      Fields of_term(remarks_, c);
      const double ratio = of_term.number("coef", 1);
      const Term term = joint(of_term, "joint", ratio);
      if (ratio != 0) terms.push_back(term);
      of_term.finish();
    }
    const std::optional<double> rest = springlength(f);
    Pull pull{.stiffness = settings_.springs ? f.number("stiffness", 0, not_negative) : 0,
              .damping = settings_.dampers ? f.number("damping", 0, not_negative) : 0};
    const bool limited = is_limited(f, settings_, "limited", "range") && settings_.limits;
    const auto range = f.numbers("range", 2, 2);
    f.pass({"group", "width", "material", "rgba", "user", "actuatorfrcrange", "actuatorfrclimited", "stiffness",
            "damping"});
    for (const char* other : {"frictionloss", "armature"}) f.leave_out(other, "of a tendon is not supported");
    leave_softness(f);
    f.finish();
    if (terms.size() == 1 && terms[0].degree->kind != Freedom::ball) {
      const Term& only = terms[0];
      pull.rest = rest.value_or(only.ratio * only.reference);
      only.add(pull);
      if (limited) {
        Degree& d = *only.degree;
        double low = only.coordinate(range[0]), high = only.coordinate(range[1]);
        if (low > high) std::swap(low, high);
        if (d.range) low = max(low, d.range->first), high = min(high, d.range->second);
        d.range = {low, high};
      }
    } else if (limited || pull.stiffness > 0 || pull.damping > 0) {
      remarks_.warn(e.at, "couples several joints: its spring, damping and range are left out");
    }
    tendons_[name] = std::move(terms);
  }

  // One number; of two, between which it is slack, the first. None: the length that it has to begin with.
  std::optional<double> springlength(Fields& f) {
    const auto x = f.numbers("springlength", 1, 2);
    if (x.size() == 2 && x[0] != x[1])
      f.leave_out("springlength",
                  "names two lengths between which it is slack, which is not supported: the first is taken");
    return x.empty() || x[0] == -1 ? std::nullopt : std::optional(x[0]);
  }

  void equality(const XmlElement& e) {
    Fields f = file_.fields(e, {}, "equality");
    f.pass({"name"});
    leave_softness(f);
    const bool active = f.flag("active", true);
    const auto polynomial = f.numbers("polycoef", 1, 5);
    Degree& d = *joint(f, "joint1").degree;
    if (f.has("joint2")) {
      joint(f, "joint2");
      if (active) remarks_.warn(e.at, "couples two joints, which is not supported: both move freely");
    } else if (active && d.kind != Freedom::ball) {
      const double held = polynomial.empty() ? 0 : polynomial[0];
      d.range = {held, held};
    }
    f.finish();
  }

  void actuator(const XmlElement& e) {
    Fields f = file_.fields(e);
    f.pass({"name", "group", "user"});
    const std::vector<Term> terms = target(f);
    const auto gear = f.numbers("gear", 1, 6);
    Pull pull;
    double control = 0;
    if (is_limited(f, settings_, "ctrllimited", "ctrlrange")) {
      const auto range = f.numbers("ctrlrange", 2, 2);
      control = clamp(0.0, range[0], max(range[0], range[1]));
    }
    if (is_limited(f, settings_, "forcelimited", "forcerange")) {
      const auto range = f.numbers("forcerange", 2, 2);
      pull.most = max(abs(range[0]), abs(range[1]));
      if (range[0] != -range[1]) f.leave_out("forcerange", "is not the same both ways: the larger counts");
    }
    double constant = 0;  // force that depends on nothing
    const bool known = law(e, f, control, pull, constant);
    for (const char* name :
         {"lengthrange", "cranklength", "actdim", "actlimited", "actrange", "actearly", "armature", "damping"})
      f.pass({name});
    f.finish();
    if (!known || !settings_.actuators) return;
    if (pull.stiffness > 0) {
      pull.rest = constant / pull.stiffness;
    } else if (pull.damping > 0) {
      pull.rate = constant / pull.damping;
    } else {
      if (constant != 0) remarks_.warn(e.at, "pulls with a constant force to begin with, which is left out");
      return;
    }
    if (terms.size() != 1 || terms[0].degree->kind == Freedom::ball) {
      remarks_.warn(e.at, "acts on something else than one hinge or slide, and is left out");
      return;
    }
    Term only = terms[0];
    only.ratio *= gear.empty() ? 1 : gear[0];
    if (only.ratio == 0) return;
    only.add(pull);
    remarks_.note(e.at, "acts as with the control 0, or the one of its range that is next to it");
  }

  // The degrees that it acts on.
  std::vector<Term> target(Fields& f) {
    if (f.has("joint")) return {joint(f, "joint")};
    if (f.has("jointinparent")) return {joint(f, "jointinparent")};
    if (f.has("tendon")) {
      const auto it = tendons_.find(f.text("tendon"));
      return it == tendons_.end() ? std::vector<Term>{} : it->second;
    }
    f.pass({"site", "refsite", "cranksite", "slidersite", "body"});
    return {};
  }

  // Its force with that control as a pull, a spring that rests at `constant` / stiffness.
  bool law(const XmlElement& e, Fields& f, double control, Pull& pull, double& constant) {
    const auto nothing = [&] {
      remarks_.note(e.at, "does nothing as long as its control is 0");
      return false;
    };
    if (e.name == "motor") {
      f.pass({"gaintype", "biastype", "gainprm", "biasprm", "dyntype", "dynprm"});  // of the defaults that it shares
      return nothing();
    }
    if (e.name == "position" || e.name == "intvelocity") {
      pull.stiffness = f.number("kp", 1, not_negative);
      pull.damping = f.number("kv", 0, not_negative);
      f.leave_out("dampratio", "is not supported: give kv");
      f.pass({"timeconst", "inheritrange", "gaintype", "biastype", "gainprm", "biasprm", "dyntype", "dynprm"});
      constant = e.name == "position" ? pull.stiffness * control : 0;
      return true;
    }
    if (e.name == "velocity") {
      pull.damping = f.number("kv", 1, not_negative);
      constant = pull.damping * control;
      f.pass({"gaintype", "biastype", "gainprm", "biasprm", "dyntype", "dynprm"});
      return true;
    }
    if (e.name == "general") {
      const std::size_t gain = f.choice("gaintype", 0, {"fixed", "affine", "muscle", "user"});
      const std::size_t bias = f.choice("biastype", 0, {"none", "affine", "muscle", "user"});
      const std::size_t dynamics =
          f.choice("dyntype", 0, {"none", "integrator", "filter", "filterexact", "muscle", "user"});
      const auto gains = f.numbers("gainprm", 0, 10), biases = f.numbers("biasprm", 0, 10);
      f.pass({"dynprm"});
      if (gain > 0 || bias > 1 || dynamics > 3) {
        remarks_.warn(e.at, "is of a kind that is not supported, and left out");
        return false;
      }
      const auto number = [](const std::vector<double>& all, std::size_t k, double otherwise) {
        return k < all.size() ? all[k] : otherwise;
      };
      constant = number(gains, 0, 1) * (dynamics == 0 ? control : 0);
      if (bias == 1)
        constant += number(biases, 0, 0), pull.stiffness = -number(biases, 1, 0), pull.damping = -number(biases, 2, 0);
      if (pull.stiffness < 0 || pull.damping < 0) {
        remarks_.warn(e.at, "pushes away from where it is, or the more the faster: left out");
        return false;
      }
      return true;
    }
    if (e.name == "damper" || e.name == "cylinder") {
      f.pass({"kv", "timeconst", "area", "diameter", "bias", "gaintype", "biastype", "gainprm", "biasprm", "dyntype",
              "dynprm"});
      return nothing();
    }
    for (const XmlAttribute& a : e.attributes) f.pass({a.name});
    remarks_.warn(e.at, in_quotes(e.name) + " is not supported, and left out");
    return false;
  }

  MjcfBodies& bodies_;
  Remarks& remarks_;
  const MjcfFile& file_;
  const MjcfSettings& settings_;
  Tendons tendons_;
};

Pos position(const Vec3d& p) { return {p.x, p.y, p.z}; }

class Ties {
 public:
  Ties(Assembly& assembly, const MjcfNames& names, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings)
      : assembly_(assembly), names_(names), remarks_(remarks), file_(file), settings_(settings) {}

  void add() {
    file_.each_in("tendon", [&](const XmlElement& e) {
      if (e.name == "spatial") tendon(e);
    });
    file_.each_in("equality", [&](const XmlElement& e) {
      if (!settings_.equalities || e.name == "joint") return;
      if (e.name == "connect" || e.name == "weld")
        tie(e);
      else
        remarks_.warn({e.at.file, e.at.line, e.name}, "an equality of this kind is not supported, and left out");
    });
  }

 private:
  Pos world(const MjcfNames::Place& p) const { return position(assembly_.frame_of(p.link).point(p.at)); }

  void tendon(const XmlElement& e) {
    Fields f = file_.fields(e);
    const std::string name = f.text("name");
    std::vector<MjcfNames::Place> ends;
    bool plain = true;
    for (const XmlElement& c : e.children) {
      Fields of_end(remarks_, c);
      if (c.name != "site") {
        plain = false;
        continue;
      }
      ends.push_back(find(names_.sites, of_end, "site", "site"));
      of_end.finish();
    }
    const double stiffness = settings_.springs ? f.number("stiffness", 0, not_negative) : 0;
    const double damping = settings_.dampers ? f.number("damping", 0, not_negative) : 0;
    const bool limited = is_limited(f, settings_, "limited", "range") && settings_.limits;
    const auto range = f.numbers("range", 2, 2), rest = f.numbers("springlength", 1, 2);
    f.pass({"group", "width", "material", "rgba", "user", "actuatorfrcrange", "actuatorfrclimited", "stiffness",
            "damping"});
    for (const char* other : {"frictionloss", "armature"}) f.leave_out(other, "of a tendon is not supported");
    leave_softness(f);
    f.finish();
    if (!limited && stiffness == 0 && damping == 0) return;  // it only measures, or an actuator pulls at it
    if (!plain || ends.size() != 2) {
      remarks_.warn(e.at, "runs over other things than two sites: its spring, damping and range are left out");
      return;
    }
    const Body a = assembly_.body_of(ends[0].link), b = assembly_.body_of(ends[1].link);
    if (a == b) return;  // nothing between them moves
    const Pos at_a = world(ends[0]), at_b = world(ends[1]);
    if (limited) {
      if (range[0] > 0)
        remarks_.warn(f.at("range"), "a least length of a tendon is not supported: it may become shorter");
      if (range[1] > 0)
        assembly_.join(Rope{.a = a, .b = b, .at_a = at_a, .at_b = at_b, .length = Real(range[1]), .collide = true},
                       e.at, name);
    }
    if (stiffness == 0 && damping == 0) return;
    if (rest.size() == 2 && rest[0] != rest[1])
      remarks_.warn(f.at("springlength"),
                    "a tendon that is slack between two lengths is not supported: the first is taken");
    const double length_at_rest = rest.empty() || rest[0] < 0 ? double(length(at_a - at_b)) : rest[0];
    const Drive spring{.mode = DriveMode::spring,
                       .target = Real(length_at_rest),
                       .force = std::numeric_limits<Real>::infinity(),
                       .stiffness = Real(stiffness),
                       .damping = Real(damping)};
    assembly_.join(Muscle{.a = a, .b = b, .at_a = at_a, .at_b = at_b, .drive = spring, .collide = true}, e.at, name);
  }

  void tie(const XmlElement& e) {
    Fields f = file_.fields(e);
    const std::string name = f.text("name");
    leave_softness(f);
    const bool active = f.flag("active", true), weld = e.name == "weld";
    MjcfNames::Place from, to;
    if (f.has("site1")) {
      from = find(names_.sites, f, "site1", "site"), to = find(names_.sites, f, "site2", "site");
      if (length(world(from) - world(to)) > Real(1e-6))
        remarks_.warn(e.at, "its two sites lie apart: the bodies are tied as they are");
    } else {
      from = {find(names_.bodies, f, "body1", "body"), f.vector("anchor")};
      to = {f.has("body2") ? find(names_.bodies, f, "body2", "body") : ground, {}};
    }
    if (weld) {
      f.mention("torquescale", "is of MuJoCo's soft constraints, and left out");
      f.pass({"anchor"});
      if (const auto pose = f.numbers("relpose", 7, 7);
          !pose.empty() && std::ranges::any_of(pose.begin() + 3, pose.end(), [](double x) { return x != 0; }))
        check_pose(e, pose, from.link, to.link);
    }
    f.finish();
    const Body a = assembly_.body_of(from.link), b = assembly_.body_of(to.link);
    if (!active || a == b) return;
    if (weld)
      assembly_.join(Fixed{.a = a, .b = b, .at = world({to.link, {}})}, e.at, name);
    else
      assembly_.join(Ball{.a = a, .b = b, .at = world(from)}, e.at, name);
  }

  void check_pose(const XmlElement& e, const std::vector<double>& pose, int from, int to) {
    const Frame now = inverse(assembly_.frame_of(from)) * assembly_.frame_of(to);
    const Quatd q = normalize(Quatd{pose[4], pose[5], pose[6], pose[3]});
    const double aligned = abs(q.x * now.q.x + q.y * now.q.y + q.z * now.q.z + q.w * now.q.w);
    if (length(now.p - Vec3d{pose[0], pose[1], pose[2]}) > 1e-6 || aligned < 1 - 1e-9)
      remarks_.warn(e.at, "would pull the bodies into another pose: they are welded as they are");
  }

  Assembly& assembly_;
  const MjcfNames& names_;
  Remarks& remarks_;
  const MjcfFile& file_;
  const MjcfSettings& settings_;
};

}

void add_joint_forces(MjcfBodies& bodies, Remarks& remarks, const MjcfFile& file, const MjcfSettings& settings) {
  JointForces(bodies, remarks, file, settings).add();
}

void add_ties(Assembly& assembly, const MjcfNames& names, Remarks& remarks, const MjcfFile& file,
              const MjcfSettings& settings) {
  Ties(assembly, names, remarks, file, settings).add();
}

}
