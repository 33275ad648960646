#include "bind.h"
#include "definition.h"

#include <sudar/difference.h>

#include <fstream>
#include <sstream>

namespace sudar::python {

namespace {

using namespace py::literals;

As<"Events"> events_of(const Events& e, const WorldPointer& w) {
  const auto touches = [&](const std::vector<Events::Touch>& list) {
    py::list out;
    for (const auto& t : list)
      out.append(result<"Touch">(bound(t.a, w), bound(t.b, w), bound(t.shape_a, w), bound(t.shape_b, w)));
    return out;
  };
  py::list hits, quarantined;
  for (const auto& h : e.hits) hits.append(result<"Hit">(bound(h.a, w), bound(h.b, w), h.at, h.normal, h.speed));
  for (const auto& q : e.quarantined) quarantined.append(result<"Quarantined">(bound(q.body, w), q.reason));
  return result<"Events">(touches(e.begun), touches(e.ended), hits, quarantined);
}

py::object contact_of(const Contact& c, const WorldPointer& w) {
  py::list points;
  for (int i = 0; i < c.count; ++i) {
    const Contact::Point& p = c.points[std::size_t(i)];
    points.append(result<"ContactPoint">(p.at, p.separation, p.normal_impulse, p.friction, p.cone_share));
  }
  return result<"Contact">(bound(c.a, w), bound(c.b, w), c.normal, points, c.friction_static, c.friction_dynamic,
                           c.restitution, c.slipping, bound(c.shape_a, w), bound(c.shape_b, w));
}

py::object hit_of(const RayHit& h, const WorldPointer& w) {
  return result<"RayHit">(bound(h.body, w), h.at, h.normal, h.distance, bound(h.shape, w));
}

py::dict profile_of(const Profile& p) {
  py::dict stages;
  for (const Profile::Stage& s : p.stages) stages[s.name] = s.microseconds;
  return py::dict("stages"_a = stages, "contacts"_a = p.contacts, "points"_a = p.points, "awake"_a = p.awake);
}

using Anything = std::variant<BoundBody, BoundShape, BoundJoint, BoundForce, BoundSensor>;

py::object ray_cast(const WorldPointer& w, const Pos& from, const Vec3& direction, Real length,
                    const std::optional<OrFields<Filter>>& filter, bool from_inside, bool all) {
  RayQuery query{.from_inside = from_inside, .all = all};
  if (filter) query.filter = filter->value;
  py::list hits;
  for (const RayHit& h : w->get().ray_cast(from, direction, length, query)) hits.append(hit_of(h, w));
  if (all) return hits;
  return hits.empty() ? py::object(py::none()) : py::object(hits[0]);
}

WorldPointer copy_of(SharedWorld& w) {
  World copy(w.get().config());
  copy.load(w.get().save());
  return std::make_shared<SharedWorld>(std::move(copy));
}

using WorldClass = py::class_<SharedWorld, WorldPointer>;

void bind_changes(WorldClass& c) {
  c.def(
      "add", [](const WorldPointer& w, const BodyDef& d) -> As<"Body"> { return bound(w->get().add(d), w); }, "body"_a);
  c.def(
      "add", [](const WorldPointer& w, const Force& d) -> As<"ForceId"> { return bound(w->get().add(d), w); },
      "force"_a);
  c.def(
      "add", [](const WorldPointer& w, const Sensor& d) -> As<"SensorId"> { return bound(w->get().add(d), w); },
      "sensor"_a);
  c.def(
      "add", [](const WorldPointer& w, const py::kwargs& fields) -> As<"Body"> {
        return bound(w->get().add(from_keywords<BodyDef>(fields)), w);
      },
      "Adds a body, given by the fields of BodyDef by name.");
  c.def(
      "join", [](const WorldPointer& w, const JointDef& d) -> As<"Joint"> { return bound(w->get().join(d), w); },
      "joint"_a, "Adds a joint.");
  c.def(
      "remove",
      [](SharedWorld& w, const Anything& what) { std::visit([&](const auto& b) { w.get().remove(b.handle); }, what); },
      "handle"_a, "A body takes its joints, forces and sensors with it.");
  c.def(
      "configure",
      [](SharedWorld& w, const py::kwargs& fields) {
        Config config = w.get().config();
        set_fields(config, fields, "");
        w.get().set_config(config);
      },
      "Changes the named fields of the configuration.");
  c.def(
      "set_pair_material",
      [](SharedWorld& w, const BoundBody& a, const BoundBody& b, const std::optional<OrFields<Material>>& m) {
        w.get().set_pair_material(a.handle, b.handle, m ? std::optional(m->value) : std::nullopt);
      },
      "a"_a, "b"_a, "material"_a,
      "What holds where the two touch, instead of the mix of their materials; None: the mix again.");
  c.def(
      "step",
      [](SharedWorld& w, std::int64_t steps, const std::optional<double>& dt) {
        const double length = dt ? *dt : w.get().config().dt;
        w.step(steps, [&](World& world) { world.step(length); });
      },
      "steps"_a = 1, py::kw_only(), "dt"_a = py::none(),
      "Goes on by that many steps of dt [s]; None: of config.dt. Other threads run meanwhile.");
}

void bind_looks(WorldClass& c) {
  c.def_property(
      "config", [](SharedWorld& w) { return Config(w.get().config()); },
      [](SharedWorld& w, const OrFields<Config>& config) { w.get().set_config(config.value); },
      "the settings: a copy, which may be changed and set");
  c.def_property_readonly(
      "time", [](SharedWorld& w) { return w.get().time(); }, "simulated, s");
  c.def_property_readonly(
      "steps", [](SharedWorld& w) { return w.get().steps(); }, "made so far");
  c.def_property_readonly(
      "bodies", [](const WorldPointer& w) -> As<"List[Body]"> { return bound(w->get().bodies(), w); });
  c.def_property_readonly(
      "joints", [](const WorldPointer& w) -> As<"List[Joint]"> { return bound(w->get().joints(), w); });
  c.def_property_readonly(
      "forces", [](const WorldPointer& w) -> As<"List[ForceId]"> { return bound(w->get().forces(), w); });
  c.def_property_readonly(
      "sensors", [](const WorldPointer& w) -> As<"List[SensorId]"> { return bound(w->get().sensors(), w); });
  c.def(
      "__getitem__", [](const WorldPointer& w, const std::string& name) -> As<"Body"> {
        const Body b = w->get().find(name);
        if (b.null()) throw py::key_error(name);
        return bound(b, w);
      },
      "name"_a, "The first body of that name; KeyError: there is none.");
  c.def(
      "__getitem__",
      [](const WorldPointer& w, const BoundBody& b) {
        return w->get()[b.handle], BoundBody{b.handle, w};
      },
      "body"_a, "The same handle in this world: of one that was loaded from what the other saved.");
  c.def(
      "__getitem__",
      [](const WorldPointer& w, const BoundJoint& j) {
        return w->get()[j.handle], BoundJoint{j.handle, w};
      },
      "joint"_a);
  c.def_property_readonly(
      "events", [](const WorldPointer& w) { return events_of(w->get().events(), w); }, "what the last step reported");
  c.def_property_readonly(
      "contacts", [](const WorldPointer& w) -> As<"List[Contact]"> {
        py::list all;
        for (const Contact& contact : w->get().contacts()) all.append(contact_of(contact, w));
        return all;
      },
      "all touching pairs");
  c.def(
      "pair_material",
      [](SharedWorld& w, const BoundBody& a, const BoundBody& b) { return w.get().pair_material(a.handle, b.handle); },
      "a"_a, "b"_a, "What holds where the two touch: set, or mixed.");
  c.def(
      "ray_cast",
      [](const WorldPointer& w, const Pos& from, const Vec3& direction, Real length,
         const std::optional<OrFields<Filter>>& filter, bool from_inside) -> As<"Optional[RayHit]"> {
        return ray_cast(w, from, direction, length, filter, from_inside, false);
      },
      "origin"_a, "direction"_a, "length"_a = infinite, py::kw_only(), "filter"_a = py::none(), "from_inside"_a = false,
      "The nearest body on the way; direction is a unit vector, length is in m. A ray that starts in a body does not "
      "see it, unless from_inside.");
  c.def(
      "ray_cast_all",
      [](const WorldPointer& w, const Pos& from, const Vec3& direction, Real length,
         const std::optional<OrFields<Filter>>& filter, bool from_inside) -> As<"List[RayHit]"> {
        return ray_cast(w, from, direction, length, filter, from_inside, true);
      },
      "origin"_a, "direction"_a, "length"_a = infinite, py::kw_only(), "filter"_a = py::none(), "from_inside"_a = false,
      "Every body on the way, nearest first.");
  c.def_property_readonly(
      "islands", [](SharedWorld& w) { return w.get().islands(); },
      "for each body the smallest index among those that it hangs together with");
  c.def_property_readonly(
      "energy", [](SharedWorld & w) -> As<"Energy"> {
        const Energy e = w.get().energy();
        return result<"Energy">(e.kinetic, e.potential);
      });
  c.def_property_readonly(
      "momentum", [](SharedWorld & w) -> As<"Momentum"> {
        const Momentum p = w.get().momentum();
        return result<"Momentum">(p.linear, p.angular);
      });
  c.def_property_readonly(
      "quality", [](SharedWorld & w) -> As<"Quality"> {
        const Quality q = w.get().quality();
        return result<"Quality">(q.penetration_max, q.penetration_mean, q.joint_gap_max, q.joint_gap_mean);
      });
  c.def_property_readonly(
      "profile", [](SharedWorld& w) { return profile_of(w.get().profile()); },
      "what the last step cost: µs a stage, counts");
}

void bind_state(WorldClass& c) {
  c.def(
      "save", [](SharedWorld& w) { return as_bytes(w.get().save()); },
      "Everything; a world that loads it goes on with the same bits.");
  c.def(
      "load", [](SharedWorld& w, const Source& data) { w.get().load(read(data)); }, "data"_a,
      "Replaces everything by what save() returned, or by a file of that.");
  c.def("copy", &copy_of, "A world of its own in the same state, in which the handles of this one are good.");
  c.def("__copy__", &copy_of);
  c.def("__deepcopy__", [](SharedWorld& w, const py::dict&) { return copy_of(w); });
  c.def(
      "hash", [](SharedWorld& w) { return w.get().hash(); }, "Of everything that can change a later bit.");
  c.def(
      "motion_hash", [](SharedWorld& w) { return w.get().motion_hash(); },
      "Of the poses and velocities of all bodies.");
  c.def(py::pickle([](SharedWorld& w) { return as_bytes(w.get().save()); },
                   [](const py::bytes& data) {
                     World w;
                     w.load(from_bytes(data.cast<std::string_view>()));
                     return std::make_shared<SharedWorld>(std::move(w));
                   }));
  c.def("__repr__", [](SharedWorld& w) {
    const World& world = w.get();
    return "<World at " + py::repr(py::float_(world.time())).cast<std::string>() +
           " s: " + std::to_string(world.bodies().size()) + " bodies, " + std::to_string(world.joints().size()) +
           " joints>";
  });
}

}

std::string path_text(const py::object& path) {
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

Bytes read(const Source& source) {
  if (py::isinstance<py::bytes>(source)) {
    const auto data = from_bytes(source.cast<std::string_view>());
    return {data.begin(), data.end()};
  }
  const std::string path = path_text(source);
  std::ifstream in(path, std::ios::binary);
  std::ostringstream whole;
  if (!(whole << in.rdbuf())) throw Error(path, "cannot be read, or is empty");
  const std::string text = whole.str();
  const auto data = from_bytes(text);
  return {data.begin(), data.end()};
}

void bind_world(py::module_& m) {
  WorldClass c(m, "World",
               "Bodies, joints and forces that move in steps. Takes the fields of Config by name, or a Config.");
  c.def(py::init([](const Config& config) { return std::make_shared<SharedWorld>(World(config)); }), "config"_a);
  c.def(py::init(
      [](const py::kwargs& fields) { return std::make_shared<SharedWorld>(World(from_keywords<Config>(fields))); }));
  bind_changes(c);
  bind_looks(c);
  bind_state(c);
  m.def(
      "difference", [](const WorldPointer& a, const WorldPointer& b) -> As<"Optional[Difference]"> {
        const std::optional<Difference> d = difference(a->get(), b->get());
        return d ? py::object(result<"Difference">(d->field, bound(d->body, a), d->index, d->a, d->b)) : py::none();
      },
      "a"_a, "b"_a, "The first field in which two worlds differ; None: they go on with the same bits.");
}

}
