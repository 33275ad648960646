// Models become worlds and scenarios.
#include <sudar/io.h>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

// Visits a definition: body numbers become bodies.
struct Named {
  const std::vector<Body>& bodies;

  void operator()(const char* field, Body& body, const auto&) const {
    if (body.null()) return;
    if (body.index >= bodies.size())
      throw Error(field, "is body number " + std::to_string(body.index) + ", which is not there");
    body = bodies[body.index];
  }
  template <class T>
  void operator()(const char*, T&, const auto&) const {}
};

template <class Def>
Def named(Def def, const std::vector<Body>& bodies) {
  Named names{bodies};
  describe(names, def);
  return def;
}
template <class... Defs>
std::variant<Defs...> named(std::variant<Defs...> def, const std::vector<Body>& bodies) {
  std::visit([&](auto& d) { d = named(std::move(d), bodies); }, def);
  return def;
}

auto made(const auto& item, auto make) {
  try {
    return make(item.def);
  } catch (const Error& e) {
    throw FileError(item.from, item.name.empty() ? e.what() : "\"" + item.name + "\": " + e.what());
  }
}

Joint join(World& w, const JointDef& def, const std::optional<JointItem::Place>& place,
           const std::vector<Body>& bodies) {
  if (!place) return w.join(def);
  if (place->body.index >= bodies.size()) throw Error("made_at", "names a body that is not there");
  const Body body = bodies[place->body.index];
  const Pose now = w[body].pose();
  w.place(body, place->at);
  const Joint joint = w.join(def);
  w.place(body, now);
  return joint;
}

class ModelScenario : public Scenario {
 public:
  explicit ModelScenario(const Model& model) : model_(model) {}
  void config(Config& c) override { c = model_.config; }
  void build(World& w) override { io::build(model_, w); }
  std::optional<Camera> camera() const override { return model_.camera; }

 private:
  const Model& model_;
};

}

std::string text(const Origin& at) {
  std::string result = at.file;
  if (at.line > 0) result.append(":").append(std::to_string(at.line));
  if (!result.empty() && !at.field.empty()) result.append(": ");
  return result.append(at.field);
}

std::string text(const Finding& f) {
  std::string result = text(Origin{f.at.file, f.at.line, {}});
  result.append(": ").append(names(f.severity)[std::size_t(f.severity)]).append(": ");
  if (!f.at.field.empty()) result.append(f.at.field).append(": ");
  return result.append(f.message);
}

Built build(const Model& model, World& w) {
  Built built;
  for (const auto& item : model.bodies) {
    built.bodies.push_back(made(item, [&](const BodyDef& d) { return w.add(d); }));
  }
  for (const JointItem& item : model.joints) {
    built.joints.push_back(
        made(item, [&](const JointDef& d) { return join(w, named(d, built.bodies), item.made_at, built.bodies); }));
  }
  for (const auto& item : model.forces) {
    made(item, [&](const Force& d) { return w.add(named(d, built.bodies)); });
  }
  for (const auto& item : model.pair_materials) {
    made(item, [&](const PairMaterial& d) {
      const PairMaterial p = named(d, built.bodies);
      w.set_pair_material(p.a, p.b, p.material);
    });
  }
  return built;
}

ModelEntry::ModelEntry(std::string name, Model model) : name_(std::move(name)), model_(std::move(model)) {
  place_ = "Files/" + name_;
  about_ = model_.name.empty() ? "a file" : model_.name;
  static_cast<ScenarioEntry&>(*this) = {.abi = abi_of_this_file(),
                                        .name = name_.c_str(),
                                        .place = place_.c_str(),
                                        .about = about_.c_str(),
                                        .seconds = model_.seconds,
                                        .picture = min(2.0, model_.seconds),
                                        .create = [](const ScenarioEntry& e) -> Scenario* {
                                          return new ModelScenario(static_cast<const ModelEntry&>(e).model());
                                        },
                                        .destroy = [](Scenario* s) { delete s; }};
}

}
