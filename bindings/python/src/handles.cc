// Handles that know their world: what is asked of the world about one body, joint, force or sensor is an attribute.
#include "bind.h"
#include "definition.h"

#include <functional>

namespace sudar::python {

namespace {

using namespace py::literals;

template <class Tag>
void declare(py::module_& m, const char* name, const char* text) {
  py::class_<Bound<Tag>>(m, name, text);
}

// What every handle has.
template <class Tag>
py::class_<Bound<Tag>> common(py::module_& m, const char* name) {
  using B = Bound<Tag>;
  py::class_<B> c = m.attr(name);
  c.def(
      "remove", [](const B& b) { b.get().remove(b.handle); }, "Takes it out of its world.");
  c.def_property_readonly(
      "index", [](const B& b) { return b.handle.index; }, "its slot in the world");
  c.def(
      "__eq__", [](const B& a, const B& b) { return a.handle == b.handle; }, py::is_operator());
  c.def("__hash__", [](const B& b) {
    return std::hash<std::uint64_t>{}(std::uint64_t(b.handle.index) << 32 | std::uint64_t(b.handle.generation) << 12 |
                                      b.handle.world);
  });
  c.def("__repr__",
        [name = std::string(name)](const B& b) { return "<" + name + " " + std::to_string(b.handle.index) + ">"; });
  return c;
}

void bind_body(py::module_& m) {
  using B = BoundBody;
  const auto view = [](const B& b) { return b.get()[b.handle]; };
  auto c = common<BodyTag>(m, "Body");
  c.def_property_readonly(
      "alive", [](const B& b) { return b.get().alive(b.handle); }, "false once it was removed");
  c.def_property(
      "position", [=](const B& b) { return view(b).pose().p; },
      [=](const B& b, const Pos& p) {
        b.get().place(b.handle, {p, view(b).pose().q});
      },
      "of the shape's frame, m; setting it moves the body there");
  c.def_property(
      "orientation", [=](const B& b) { return view(b).pose().q; },
      [=](const B& b, const Quat& q) {
        b.get().place(b.handle, {view(b).pose().p, q});
      },
      "of the shape's frame: unit quaternion x, y, z, w; may be set");
  c.def_property(
      "velocity", [=](const B& b) { return view(b).velocity(); },
      [=](const B& b, const Vec3& v) { b.get().set_velocity(b.handle, v, view(b).spin()); },
      "of the centre of mass, m/s; may be set");
  c.def_property(
      "spin", [=](const B& b) { return view(b).spin(); },
      [=](const B& b, const Vec3& spin) { b.get().set_velocity(b.handle, view(b).velocity(), spin); },
      "angular velocity, rad/s, world axes; may be set");
  c.def_property(
      "surface_velocity", [=](const B& b) { return view(b).surface_velocity(); },
      [](const B& b, const Vec3& v) { b.get().set_surface_velocity(b.handle, v); },
      "of the surface along itself, like a belt's: m/s, shape's axes; may be set");
  c.def_property_readonly(
      "center", [=](const B& b) { return view(b).center(); }, "of mass, m");
  c.def_property_readonly(
      "angular_momentum", [=](const B& b) { return view(b).angular_momentum(); },
      "about the centre of mass, world axes, N·m·s");
  c.def_property_readonly(
      "mass", [=](const B& b) { return view(b).mass(); }, "kg; 0 of a half space");
  c.def_property_readonly(
      "inertia", [=](const B& b) { return view(b).inertia(); }, "(3, 3), about the centre of mass, world axes, kg·m²");
  c.def_property_readonly(
      "kinetic_energy", [=](const B& b) { return view(b).kinetic_energy(); }, "J");
  c.def_property_readonly("shape", [=](const B& b) { return Shape(view(b).shape()); });
  c.def_property_readonly(
      "material", [=](const B& b) { return Material(view(b).material()); }, "a copy");
  c.def_property_readonly(
      "shapes", [=](const B& b) -> As<"List[ShapeId]"> { return bound(view(b).shapes(), b.world); },
      "all, in the order in which it got them; `shape` and `material` are those of the first");
  c.def(
      "add_shape", [](const B& b, const py::kwargs& fields) -> As<"ShapeId"> {
        return bound(b.get().add(b.handle, from_keywords<ShapeDef>(fields)), b.world);
      },
      "One more, given by the fields of ShapeDef by name. Mass and inertia are made anew; the body goes on as it "
      "went.");
  c.def_property_readonly("name", [=](const B& b) { return view(b).name(); });
  c.def_property_readonly(
      "motion", [=](const B& b) { return view(b).motion(); }, "\"dynamic\", \"kinematic\" or \"fixed\"");
  c.def_property_readonly("asleep", [=](const B& b) { return view(b).asleep(); });
  c.def_property_readonly(
      "quarantined", [=](const B& b) { return view(b).quarantined(); }, "its state turned non-finite: it is frozen");
  c.def(
      "velocity_at", [=](const B& b, const Pos& point) { return view(b).velocity_at(point); }, "point"_a,
      "of a point of the body [m, world]: m/s");
  c.def(
      "push",
      [=](const B& b, const Vec3& force, const std::optional<Pos>& at) {
        b.get().push(b.handle, force, at ? *at : view(b).center());
      },
      "force"_a, "at"_a = py::none(),
      "A force [N, world axes] during the next step only, at a point [m]; None: the centre of mass.");
  c.def(
      "twist", [](const B& b, const Vec3& torque) { b.get().twist(b.handle, torque); }, "torque"_a,
      "A torque [N·m, world axes] during the next step only.");
  c.def("wake", [](const B& b) { b.get().wake(b.handle); });
  c.def(
      "touches", [](const B& b, const B& other) { return b.get().touching(b.handle, other.handle); }, "other"_a);
  c.def(
      "distance", [](const B& b, const B& other) -> As<"Distance"> {
        const SignedDistance d = b.get().distance(b.handle, other.handle);
        return result<"Distance">(d.value, d.normal, d.on_a, d.on_b);
      },
      "other"_a, "To the other body's shape, touching or not.");
}

void bind_shape(py::module_& m) {
  using B = BoundShape;
  const auto view = [](const B& b) { return b.get()[b.handle]; };
  auto c = common<ShapeTag>(m, "ShapeId");
  c.def_property_readonly(
      "alive", [](const B& b) { return b.get().alive(b.handle); }, "false once it was removed");
  c.def_property_readonly(
      "body", [=](const B& b) -> As<"Body"> { return bound(view(b).body(), b.world); });
  c.def_property_readonly("shape", [=](const B& b) { return Shape(view(b).shape()); });
  c.def_property_readonly(
      "position", [=](const B& b) { return view(b).pose().p; }, "of its frame, m");
  c.def_property_readonly(
      "orientation", [=](const B& b) { return view(b).pose().q; }, "of its frame: unit quaternion x, y, z, w");
  c.def_property_readonly(
      "at", [=](const B& b) { return view(b).at().p; }, "of its frame, in the body's, m");
  c.def_property_readonly(
      "turn", [=](const B& b) { return view(b).at().q; }, "of its frame, against the body's");
  c.def_property_readonly(
      "density", [=](const B& b) { return view(b).density(); }, "kg/m³");
  c.def_property_readonly(
      "material", [=](const B& b) { return Material(view(b).material()); }, "a copy");
  c.def_property_readonly(
      "filter", [=](const B& b) { return Filter(view(b).filter()); }, "a copy");
  c.def_property_readonly(
      "surface_velocity", [=](const B& b) { return view(b).surface_velocity(); }, "m/s, shape's axes");
}

void bind_joint(py::module_& m) {
  using B = BoundJoint;
  const auto view = [](const B& b) { return b.get()[b.handle]; };
  const auto end = [=](const B& b, bool second) {
    return std::visit([&](const auto& d) { return bound(second ? d.b : d.a, b.world); }, view(b).definition());
  };
  auto c = common<JointTag>(m, "Joint");
  c.def_property_readonly(
      "alive", [](const B& b) { return b.get().alive(b.handle); }, "false once it was removed");
  c.def_property_readonly(
      "definition", [=](const B& b) { return JointDef(view(b).definition()); },
      "a copy of what it was made from, with its present drive");
  c.def_property_readonly(
      "a", [=](const B& b) -> As<"Optional[Body]"> { return end(b, false); }, "None: the world");
  c.def_property_readonly(
      "b", [=](const B& b) -> As<"Optional[Body]"> { return end(b, true); }, "None: the world");
  c.def_property_readonly(
      "anchor_a", [=](const B& b) { return view(b).anchor_a(); }, "as it is now, m");
  c.def_property_readonly(
      "anchor_b", [=](const B& b) { return view(b).anchor_b(); }, "as it is now, m");
  c.def_property_readonly(
      "gap", [=](const B& b) { return view(b).gap(); }, "how far the joint is from holding, m");
  c.def_property_readonly(
      "coordinate", [=](const B& b) { return view(b).coordinate(); },
      "angle of a hinge [rad, unwound], way of a slider, length of a rope or muscle [m]; else 0");
  c.def_property_readonly(
      "load",
      [=](const B& b) -> As<"Load"> {
        const Wrench load = view(b).load();
        return result<"Load">(load.force, load.torque);
      },
      "that it exerted on its body b in the last sub-step: N and N·m about anchor b");
  c.def_property(
      "drive",
      [=](const B& b) {
        Drive drive{};
        std::visit(
            [&](const auto& d) {
              if constexpr (requires { d.drive; }) drive = d.drive;
            },
            view(b).definition());
        return drive;
      },
      [](const B& b, const OrFields<Drive>& drive) { b.get().set_drive(b.handle, drive.value); },
      "of a joint that has one: a copy, which may be changed and set");
}

}

void declare_handles(py::module_& m) {
  declare<BodyTag>(m, "Body", "A body of a world. Its attributes ask the world; those that may be set change it.");
  declare<ShapeTag>(m, "ShapeId", "One of the shapes of a body. A body keeps at least one.");
  declare<JointTag>(m, "Joint", "A joint of a world.");
  declare<ForceTag>(m, "ForceId", "A force that acts in a world until it is removed.");
  declare<SensorTag>(m, "SensorId", "A sensor of a world.");
}

void bind_handles(py::module_& m) {
  bind_body(m);
  bind_shape(m);
  bind_joint(m);
  common<ForceTag>(m, "ForceId")
      .def_property_readonly(
          "definition", [](const BoundForce& f) { return Force(f.get()[f.handle]); }, "a copy");
  common<SensorTag>(m, "SensorId")
      .def_property_readonly(
          "definition", [](const BoundSensor& s) { return Sensor(s.get()[s.handle]); }, "a copy")
      .def_property_readonly(
          "value", [](const BoundSensor& s) { return s.get().value(s.handle); },
          "after the last step, in the unit of its kind");
}

}
