#include "bind.h"

#include <sudar/record.h>

#include <algorithm>
#include <fstream>

namespace sudar::python {

namespace {

using namespace py::literals;

class Recording {
 public:
  Recording(WorldPointer w, const std::string& title)
      : world_(std::move(w)), recorder_(std::make_unique<Recorder>(world_->get(), title)) {
    world_->recorders.push_back(recorder_.get());
  }
  ~Recording() { stop(); }
  Recording(const Recording&) = delete;

  void stop() {
    if (!recorder_) return;
    world_->get();  // not while another thread steps it
    whole_ = recorder_->bytes();
    std::erase(world_->recorders, recorder_.get());
    recorder_.reset();
  }
  Bytes bytes() const { return recorder_ ? (world_->get(), recorder_->bytes()) : whole_; }
  void save(const Path& path) const {
    const std::string name = path_text(path);
    const Bytes data = bytes();
    std::ofstream out(name, std::ios::binary);
    out.write(reinterpret_cast<const char*>(data.data()), std::streamsize(data.size()));
    if (!out.flush()) throw Error(name, "cannot be written");
  }

 private:
  WorldPointer world_;
  std::unique_ptr<Recorder> recorder_;
  Bytes whole_;
};

class SharedReplay {
 public:
  SharedReplay(Bytes data, std::int32_t workers)
      : replay(std::make_shared<Replay>(std::move(data), workers)),
        world(std::make_shared<SharedWorld>(replay->world(), replay)) {}
  std::shared_ptr<Replay> replay;
  WorldPointer world;

  // None: as recorded.
  py::object step(bool check) {
    std::optional<Divergence> d;
    world->step(1, [&](World&) { d = replay->step(check); });
    return d ? py::object(result<"Divergence">(d->step, d->stage, d->field, bound(d->body, world))) : py::none();
  }
};

}

void bind_recordings(py::module_& m) {
  py::class_<Recording>(m, "Recording",
                        "Of all that is done to a world, from here to stop(); a context manager, which stops at its "
                        "end. `sudar replay` plays its file.")
      .def(py::init<WorldPointer, const std::string&>(), "world"_a, "title"_a = "")
      .def("stop", &Recording::stop)
      .def(
          "__enter__", [](py::object self) -> As<"Recording"> { return self; })
      .def("__exit__", [](Recording& r, const py::args&) { r.stop(); })
      .def("__bytes__", [](const Recording& r) { return as_bytes(r.bytes()); })
      .def("save", &Recording::save, "path"_a, "Writes the recording so far.");
  py::class_<SharedReplay>(m, "Replay",
                           "A recording, played step by step: iterate over it. Each step gives None, or where it "
                           "differs from what was recorded.")
      .def(py::init([](const Source& data, std::int32_t workers) {
             return std::make_unique<SharedReplay>(read(data), workers);
           }),
           "recording"_a, "workers"_a = 1, "From bytes or a path.")
      .def_property_readonly("world", [](const SharedReplay& r) { return r.world; })
      .def_property_readonly("title", [](const SharedReplay& r) { return r.replay->title(); })
      .def_property_readonly(
          "cut_off", [](const SharedReplay& r) { return r.replay->cut_off(); },
          "it has no end: these are the whole steps that there are")
      .def_property_readonly("done", [](const SharedReplay& r) { return r.replay->done(); })
      .def("__len__", [](const SharedReplay& r) { return r.replay->steps(); })
      .def(
          "step", [](SharedReplay & r, bool check) -> As<"Optional[Divergence]"> {
            if (r.replay->done()) throw py::index_error("the recording is over");
            return r.step(check);
          },
          "check"_a = true, "Plays the next step.")
      .def(
          "__iter__", [](py::object self) -> As<"Replay"> { return self; })
      .def(
          "__next__", [](SharedReplay & r) -> As<"Optional[Divergence]"> {
            if (r.replay->done()) throw py::stop_iteration();
            return r.step(true);
          });
}

}
