// The state of all bodies as arrays; many worlds at once.
#include "bind.h"

#include <sudar/batch.h>

namespace sudar::python {

namespace {

using namespace py::literals;
using Vectors = As<"Array">;

// What the arrays hold of a body, each a row.
Pos position_of(const BodyView& b) { return b.pose().p; }
Quat orientation_of(const BodyView& b) { return b.pose().q; }
Vec3 velocity_of(const BodyView& b) { return b.velocity(); }
Vec3 spin_of(const BodyView& b) { return b.spin(); }

template <class F>
using Row = std::invoke_result_t<F, const BodyView&>;

template <class F>
void write_rows(const World& w, F of, double* to) {
  for (const Body b : w.bodies()) write_numbers(of(w[b]), to), to += Numbers<Row<F>>::rows;
}

template <class F>
Vectors rows(const World& w, F of) {
  Array array({py::ssize_t(w.bodies().size()), py::ssize_t(Numbers<Row<F>>::rows)});
  write_rows(w, of, array.mutable_data());
  return py::object(array);
}

class WorldBatch {
 public:
  WorldBatch(SharedWorld& prototype, std::int64_t count, std::int32_t threads)
      : batch_(threads), start_(prototype.get().save()) {
    if (count < 1) throw Error("count", "is " + std::to_string(count) + ", must be at least 1");
    for (std::int64_t i = 0; i < count; ++i) {
      World w;
      w.load(start_);
      worlds_.push_back(std::make_shared<SharedWorld>(std::move(w)));
    }
  }

  std::int64_t size() const { return std::int64_t(worlds_.size()); }
  std::int32_t threads() const { return batch_.threads(); }
  py::list list() const { return py::cast(worlds_); }
  WorldPointer at(std::int64_t i) const {
    if (i < 0) i += size();
    if (i < 0 || i >= size()) throw py::index_error("there are " + std::to_string(size()) + " worlds");
    return worlds_[std::size_t(i)];
  }

  void step(std::int64_t steps) {
    std::vector<World*> worlds;
    std::vector<std::unique_ptr<SharedWorld::Busy>> busy;
    bool recorded = false;
    for (const WorldPointer& w : worlds_) {
      worlds.push_back(&w->get());
      recorded |= !w->recorders.empty();
    }
    for (const WorldPointer& w : worlds_) busy.push_back(std::make_unique<SharedWorld::Busy>(*w));
    // Several steps at once spare the threads a meeting after each; but recorders hear of every one.
    const std::int64_t piece = recorded ? 1 : 16;
    if (batch_.threads() > 1) threads_.require_them();
    const py::gil_scoped_release released;
    Interrupts interrupts;
    for (std::int64_t left = checked(steps); left > 0; left -= piece, interrupts.look()) {
      batch_.step(worlds, std::min(left, piece));
      for (const WorldPointer& w : worlds_) w->tell_recorders();
    }
  }

  void reset(const std::optional<std::vector<std::int64_t>>& which) {
    if (!which) {
      for (const WorldPointer& w : worlds_) w->get().load(start_);
      return;
    }
    for (const std::int64_t i : *which) at(i)->get().load(start_);
  }

  template <class F>
  Vectors rows_of_all(F of) const {
    const std::size_t bodies = worlds_[0]->get().bodies().size();
    const std::size_t row = Numbers<Row<F>>::rows;
    Array array({py::ssize_t(size()), py::ssize_t(bodies), py::ssize_t(row)});
    for (std::size_t i = 0; i < worlds_.size(); ++i) {
      const World& w = worlds_[i]->get();
      if (w.bodies().size() != bodies) throw std::runtime_error("the worlds no longer have equally many bodies");
      write_rows(w, of, array.mutable_data() + i * bodies * row);
    }
    return py::object(array);
  }

  Vectors coordinates(const std::vector<BoundJoint>& joints) const {
    Array array({py::ssize_t(size()), py::ssize_t(joints.size())});
    double* to = array.mutable_data();
    for (const WorldPointer& w : worlds_) {
      for (const BoundJoint& j : joints) *to++ = double(w->get()[j.handle].coordinate());
    }
    return py::object(array);
  }

  // f(world, row i of values) for every world; an array of one row is that of all.
  template <class T, class F>
  void each(const char* name, const Array& values, F f) {
    const py::ssize_t width = Numbers<T>::rows;
    const bool same = values.ndim() == 1 && values.shape(0) == width;
    if (!same && !(values.ndim() == 2 && values.shape(0) == size() && values.shape(1) == width)) {
      throw Error(name, "has another shape than (" + std::to_string(size()) + ", " + std::to_string(width) + ") or (" +
                            std::to_string(width) + ",)");
    }
    for (std::int64_t i = 0; i < size(); ++i) {
      T value{};
      for (int k = 0; k < width; ++k) {
        auto& to = Numbers<T>::at(value, k, 0);
        to = static_cast<std::remove_reference_t<decltype(to)>>(values.data()[(same ? 0 : i * width) + k]);
      }
      f(worlds_[std::size_t(i)]->get(), value);
    }
  }

  void set_targets(const BoundJoint& bound, const Array& targets) {
    const Joint joint = bound.handle;
    if (targets.size() != 1 && !(targets.ndim() == 1 && targets.shape(0) == size())) {
      throw Error("targets", "must be one number or have the shape (" + std::to_string(size()) + ",)");
    }
    for (std::int64_t i = 0; i < size(); ++i) {
      World& w = worlds_[std::size_t(i)]->get();
      const double target = targets.data()[targets.size() == 1 ? 0 : i];
      std::visit(
          [&](const auto& d) {
            if constexpr (requires { d.drive; }) {
              Drive drive = d.drive;
              drive.target = Real(target);
              w.set_drive(joint, drive);
            } else {
              throw Error("joint", "has no drive");
            }
          },
          w[joint].definition());
    }
  }

 private:
  Batch batch_;
  HasThreads threads_;
  Bytes start_;
  std::vector<WorldPointer> worlds_;
};

void bind_batch(py::module_& m) {
  py::class_<WorldBatch> c(
      m, "WorldBatch",
      "Copies of a world, stepped side by side by several threads: each has the bits that it has alone. Handles of the "
      "first world are good in all of them. Arrays have the worlds as their first axis; what is set may also be one "
      "row for all.");
  c.def(py::init<SharedWorld&, std::int64_t, std::int32_t>(), "world"_a, "count"_a, "threads"_a = 0);
  c.def("__len__", &WorldBatch::size);
  c.def("__getitem__", &WorldBatch::at, "index"_a);
  c.def(
      "__iter__", [](const WorldBatch& b) -> As<"Iterator[World]"> { return py::iter(b.list()); });
  c.def_property_readonly("threads", &WorldBatch::threads);
  c.def("step", &WorldBatch::step, "steps"_a = 1,
        "Every world by that many steps of its config.dt. Other threads of Python run meanwhile.");
  c.def("reset", &WorldBatch::reset, "which"_a = py::none(),
        "Takes those worlds, or all, back to the state in which the batch was made.");
  c.def_property_readonly(
      "positions", [](const WorldBatch& b) { return b.rows_of_all(position_of); },
      "(worlds, bodies, 3), of the shapes' frames, m");
  c.def_property_readonly(
      "orientations", [](const WorldBatch& b) { return b.rows_of_all(orientation_of); },
      "(worlds, bodies, 4): x, y, z, w");
  c.def_property_readonly(
      "velocities", [](const WorldBatch& b) { return b.rows_of_all(velocity_of); },
      "(worlds, bodies, 3), of the centres of mass, m/s");
  c.def_property_readonly(
      "spins", [](const WorldBatch& b) { return b.rows_of_all(spin_of); }, "(worlds, bodies, 3), rad/s");
  c.def("coordinates", &WorldBatch::coordinates, "joints"_a,
        "(worlds, joints): angles [rad] and ways [m], as Joint.coordinate.");
  c.def(
      "push",
      [](WorldBatch& b, const BoundBody& bound, const Array& forces) {
        const Body body = bound.handle;
        b.each<Vec3>("forces", forces, [=](World& w, const Vec3& force) { w.push(body, force, w[body].center()); });
      },
      "body"_a, "forces"_a, "(worlds, 3): N, at the centre of mass, during the next step only.");
  c.def(
      "twist",
      [](WorldBatch& b, const BoundBody& bound, const Array& torques) {
        const Body body = bound.handle;
        b.each<Vec3>("torques", torques, [=](World& w, const Vec3& torque) { w.twist(body, torque); });
      },
      "body"_a, "torques"_a, "(worlds, 3): N·m, world axes, during the next step only.");
  c.def(
      "set_velocities",
      [](WorldBatch& b, const BoundBody& bound, const Array& velocities) {
        const Body body = bound.handle;
        b.each<Vec3>("velocities", velocities,
                     [=](World& w, const Vec3& v) { w.set_velocity(body, v, w[body].spin()); });
      },
      "body"_a, "velocities"_a, "(worlds, 3): m/s.");
  c.def(
      "set_spins",
      [](WorldBatch& b, const BoundBody& bound, const Array& spins) {
        const Body body = bound.handle;
        b.each<Vec3>("spins", spins,
                     [=](World& w, const Vec3& spin) { w.set_velocity(body, w[body].velocity(), spin); });
      },
      "body"_a, "spins"_a, "(worlds, 3): rad/s.");
  c.def(
      "set_positions",
      [](WorldBatch& b, const BoundBody& bound, const Array& positions) {
        const Body body = bound.handle;
        b.each<Pos>("positions", positions, [=](World& w, const Pos& p) { w.place(body, {p, w[body].pose().q}); });
      },
      "body"_a, "positions"_a, "(worlds, 3): m.");
  c.def(
      "set_orientations",
      [](WorldBatch& b, const BoundBody& bound, const Array& orientations) {
        const Body body = bound.handle;
        b.each<Quat>("orientations", orientations, [=](World& w, const Quat& q) {
          w.place(body, {w[body].pose().p, q});
        });
      },
      "body"_a, "orientations"_a, "(worlds, 4): unit quaternions x, y, z, w.");
  c.def("set_targets", &WorldBatch::set_targets, "joint"_a, "targets"_a,
        "(worlds,): of the joint's drive, in the unit of its mode.");
}

// Arrays that are made once and filled again and again.
class BodyArrays {
 public:
  explicit BodyArrays(WorldPointer w) : world_(std::move(w)) { update(); }
  void update() {
    const World& w = world_->get();
    const auto n = py::ssize_t(w.bodies().size());
    if (!positions || positions.shape(0) != n) {
      positions = Array({n, py::ssize_t(3)}), orientations = Array({n, py::ssize_t(4)});
      velocities = Array({n, py::ssize_t(3)}), spins = Array({n, py::ssize_t(3)});
    }
    write_rows(w, position_of, positions.mutable_data());
    write_rows(w, orientation_of, orientations.mutable_data());
    write_rows(w, velocity_of, velocities.mutable_data());
    write_rows(w, spin_of, spins.mutable_data());
  }
  Array positions{}, orientations{}, velocities{}, spins{};

 private:
  WorldPointer world_;
};

}

void bind_arrays(py::module_& m) {
  py::class_<BodyArrays>(m, "BodyArrays",
                         "The state of all bodies of a world, in the order of World.bodies, as of the last update().")
      .def("update", &BodyArrays::update,
           "Reads the world again. With more or fewer bodies than before the arrays are new ones.")
      .def_property_readonly(
          "positions", [](const BodyArrays& a) -> Vectors { return py::object(a.positions); }, "(bodies, 3), m")
      .def_property_readonly(
          "orientations", [](const BodyArrays& a) -> Vectors { return py::object(a.orientations); },
          "(bodies, 4): x, y, z, w")
      .def_property_readonly(
          "velocities", [](const BodyArrays& a) -> Vectors { return py::object(a.velocities); }, "(bodies, 3), m/s")
      .def_property_readonly(
          "spins", [](const BodyArrays& a) -> Vectors { return py::object(a.spins); }, "(bodies, 3), rad/s");
  py::class_<SharedWorld, WorldPointer> c = m.attr("World");
  c.def_property_readonly(
      "positions", [](SharedWorld& w) { return rows(w.get(), position_of); },
      "(bodies, 3), of the shapes' frames, m, in the order of `bodies`");
  c.def_property_readonly(
      "orientations", [](SharedWorld& w) { return rows(w.get(), orientation_of); }, "(bodies, 4): x, y, z, w");
  c.def_property_readonly(
      "velocities", [](SharedWorld& w) { return rows(w.get(), velocity_of); },
      "(bodies, 3), of the centres of mass, m/s");
  c.def_property_readonly(
      "spins", [](SharedWorld& w) { return rows(w.get(), spin_of); }, "(bodies, 3), rad/s");
  c.def(
      "arrays", [](const WorldPointer& w) { return BodyArrays(w); },
      "The four as arrays that stay where they are: update() fills them again, and what numpy made of them sees it.");
  bind_batch(m);
}

}
