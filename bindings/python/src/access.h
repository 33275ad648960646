// A world as Python holds it: whoever owns it stays alive with it, and while a thread steps it, with the interpreter's
// lock released, every other thread that asks for it is refused instead of reading what is being written.
#pragma once

#include <sudar/record.h>

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <vector>

#include <pybind11/pybind11.h>

namespace sudar::python {

namespace py = pybind11;

// Lets Python end long work: Ctrl+C, or whatever its signals raise. For threads that have released the interpreter's
// lock.
class Interrupts {
 public:
  void look() {
    const auto now = std::chrono::steady_clock::now();
    if (now - last_ < std::chrono::milliseconds(50)) return;
    last_ = now;
    const py::gil_scoped_acquire acquired;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// Of what has threads of its own. A fork copies none of them, but the locks that they held.
class HasThreads {
 public:
  void require_them() const {
    if (getpid() != process_) {
      throw std::runtime_error("this process was forked, which leaves threads behind: use a copy made in this process");
    }
  }

 private:
  pid_t process_ = getpid();
};

inline std::int64_t checked(std::int64_t steps) {
  if (steps < 0) throw Error("steps", "is " + std::to_string(steps) + ", must not be negative");
  return steps;
}

class SharedWorld : public std::enable_shared_from_this<SharedWorld> {
 public:
  explicit SharedWorld(World own) : SharedWorld(std::make_shared<World>(std::move(own))) {}
  // A world that something else owns, a session or a replay.
  SharedWorld(World& world, std::shared_ptr<void> owner) : own_(std::move(owner)), world_(&world) {}

  World& get() {
    if (busy_.load(std::memory_order_acquire)) throw std::runtime_error("the world is being stepped by another thread");
    return *world_;
  }
  // Runs f(world) with the interpreter's lock released.
  template <class F>
  void work(F f) {
    const Busy busy(*this);
    if (world_->config().workers > 1) threads_.require_them();
    const py::gil_scoped_release released;
    f(*world_);
  }
  // advance(world) as long as more(), each time a step, of which the recorders hear. Python may interrupt it.
  template <class More, class F>
  void run(More more, F advance) {
    work([&](World& w) {
      for (Interrupts interrupts; more(); interrupts.look()) advance(w), tell_recorders();
    });
  }
  template <class F>
  void step(std::int64_t steps, F advance) {
    run([left = checked(steps)]() mutable { return left-- > 0; }, advance);
  }
  std::vector<Recorder*> recorders;
  void tell_recorders() {
    for (Recorder* r : recorders) r->after_step();
  }

  class Busy {
   public:
    explicit Busy(SharedWorld& w) : w_(w) { w.get(), w_.busy_.store(true, std::memory_order_release); }
    ~Busy() { w_.busy_.store(false, std::memory_order_release); }
    Busy(const Busy&) = delete;

   private:
    SharedWorld& w_;
  };

 private:
  explicit SharedWorld(const std::shared_ptr<World>& own) : SharedWorld(*own, own) {}
  std::shared_ptr<void> own_;
  World* world_ = nullptr;
  HasThreads threads_;
  std::atomic<bool> busy_ = false;
};
using WorldPointer = std::shared_ptr<SharedWorld>;

// A handle and, where it is known, the world that it is of. A definition's handles know none.
template <class Tag>
struct Bound {
  Handle<Tag> handle{};
  WorldPointer world{};

  World& get() const {
    if (!world)
      throw std::runtime_error("this handle was read from a definition and knows no world; world[handle] does");
    return world->get();
  }
};
using BoundBody = Bound<BodyTag>;
using BoundJoint = Bound<JointTag>;
using BoundShape = Bound<ShapeTag>;
using BoundForce = Bound<ForceTag>;
using BoundSensor = Bound<SensorTag>;

}
