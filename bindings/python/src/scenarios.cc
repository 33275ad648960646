// Scenarios by name. The plugins are loaded when first asked for and never unloaded: worlds may live as long as Python.
#include "bind.h"

#include <sudar/session.h>

#include <dlfcn.h>

#include <filesystem>

#include "main/plugins.h"
#ifdef SUDAR_IO
#include <sudar/io.h>
#endif

namespace sudar::python {

namespace {

using namespace py::literals;

// Beside this module, as beside the program: see cmake/install.cmake.
std::string folder_of_scenarios() {
#ifdef SUDAR_STATIC_SCENARIOS
  return {};
#else
  if (const char* set = std::getenv("SUDAR_SCENARIOS"); set && *set) return set;
  Dl_info module;
  if (dladdr(reinterpret_cast<void*>(&folder_of_scenarios), &module) == 0)
    throw Error("scenarios", "this module does not know where it is");
  return std::filesystem::path(module.dli_fname).parent_path() / SUDAR_SCENARIOS_FROM_MODULE;
#endif
}

const Catalogue& catalogue() {
  static const app::Plugins& plugins = []() -> const app::Plugins& {
    auto* loaded = new app::Plugins(folder_of_scenarios());
#ifdef SUDAR_IO
    static auto* files = new io::FileScenes({}, [](const io::Finding& f) {
      if (f.severity == io::Severity::warning) PyErr_WarnEx(PyExc_UserWarning, io::text(f).c_str(), 1);
    });
    loaded->open_with([](std::string_view name) { return files->open(name); });
#endif
    for (const std::string& reason : loaded->refused()) PyErr_WarnEx(PyExc_RuntimeWarning, reason.c_str(), 1);
    return *loaded;
  }();
  return plugins.catalogue();
}

// {"dt": 0.01, "soft_step": {"lanes": 4}} as paths and values.
void add_paths(std::vector<std::pair<std::string, std::string>>& to, const py::dict& fields,
               const std::string& prefix) {
  for (const auto& [key, value] : fields) {
    const std::string path = prefix + py::str(key).cast<std::string>();
    if (py::isinstance<py::dict>(value))
      add_paths(to, py::reinterpret_borrow<py::dict>(value), path + ".");
    else if (py::isinstance<py::bool_>(value))
      to.emplace_back(path, value.cast<bool>() ? "true" : "false");
    else
      to.emplace_back(path, py::str(value));
  }
}

class SharedSession {
 public:
  explicit SharedSession(Session s)
      : session(std::make_shared<Session>(std::move(s))),
        world(std::make_shared<SharedWorld>(session->world(), session)) {}
  std::shared_ptr<Session> session;
  WorldPointer world;

  void step(std::int64_t steps) {
    world->step(steps, [&](World&) { session->step(); });
  }
  void run() {
    world->run([&] { return !session->done(); }, [&](World&) { session->step(); });
    session->finish();
  }
};

SharedSession make_session(const std::string& name, const py::dict& config, const std::optional<double>& seconds,
                           const py::kwargs& parameters) {
  Settings settings{.seconds = seconds};
  for (const auto& [key, value] : parameters) {
    py::detail::make_caster<double> number;
    if (!number.load(value, true))
      throw Error(py::str(key), "is " + py::repr(value).cast<std::string>() + ", expected a number");
    settings.set[py::str(key)] = py::detail::cast_op<double>(number);
  }
  add_paths(settings.config, config, "");
  return SharedSession(Session(catalogue().find(name), settings));
}

As<"List[Check]"> checks_of(const Check& check) {
  py::list all;
  for (const Check::Entry& e : check.entries()) {
    all.append(result<"Check">(e.name, e.op, e.value, e.limit, e.tolerance, e.unit, e.at, e.pass));
  }
  return py::object(all);
}

constexpr const char* kind_names[] = {"integer", "real", "boolean"};

}

void bind_scenarios(py::module_& m) {
  m.def(
      "scenarios", []() -> As<"List[ScenarioInfo]"> {
        py::list all;
        for (const ScenarioEntry* e : catalogue().all())
          all.append(result<"ScenarioInfo">(e->name, e->place, e->about, e->seconds));
        return py::object(all);
      },
      "All that there are, in the order of the program's browser.");
  py::class_<SharedSession>(
      m, "Session",
      "A scenario being run: Session(\"wall\", ball=0), or a file: Session(\"robot.glb\"). Parameters of the scenario by name; what differs from its own "
      "configuration in `config`, a dict of fields of Config; `seconds` to simulate, None: the scenario's own.")
      .def(py::init(&make_session), "scenario"_a, "config"_a = py::dict(), "seconds"_a = py::none())
      .def_static(
          "load", [](const Source& data) { return SharedSession(Session::load(catalogue(), read(data))); }, "data"_a,
          "Goes on where save() was called; from bytes or a path.")
      .def("save", [](const SharedSession& s) { return s.world->get(), as_bytes(s.session->save()); })
      .def("step", &SharedSession::step, "steps"_a = 1, "Steps, with what the scenario does and watches.")
      .def(
          "run", [](SharedSession& s) { return s.run(), checks_of(s.session->check()); },
          "To the end; returns the verdicts.")
      .def_property_readonly("world", [](const SharedSession& s) { return s.world; })
      .def_property_readonly("name", [](const SharedSession& s) { return s.session->entry().name; })
      .def_property_readonly(
          "seconds", [](const SharedSession& s) { return s.session->seconds(); }, "at which it ends, simulated")
      .def_property_readonly("done", [](const SharedSession& s) { return s.world->get(), s.session->done(); })
      .def_property_readonly(
          "parameters", [](const SharedSession& s) -> As<"List[Parameter]"> {
            py::list all;
            for (const Params::Entry& p : s.session->params())
              all.append(result<"Parameter">(p.name, kind_names[int(p.kind)], p.value, p.low, p.high, p.about));
            return py::object(all);
          })
      .def_property_readonly(
          "checks", [](const SharedSession& s) { return s.world->get(), checks_of(s.session->check()); },
          "the verdicts so far; those at the end come with run()")
      .def_property_readonly(
          "passed", [](const SharedSession& s) { return s.world->get(), s.session->check().passed(); },
          "every verdict there is, is good, and there is at least one")
      .def(
          "hold",
          [](SharedSession& s, std::vector<std::string> keys) {
            s.world->get();
            for (const std::string& key : keys) {
              if (!Input::is_key(key))
                throw Error("keys", "\"" + key + "\" is none of " + Input::named_keys + ", a to z, 0 to 9");
            }
            s.session->input.set(std::move(keys));
          },
          "keys"_a, "The keys that are held from now on, by name: \"up\", \"left\", \"space\", \"a\"…");
}

}
