#include "ui/status.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "main/files.h"

namespace sudar::ui {

using Json = nlohmann::ordered_json;

namespace {
template <class V>
Json list(const V& v) {
  return {v.x, v.y, v.z};
}
}  // namespace

void StatusFile::write(const Controls& c, const Window& window, double frames_per_second) {
  ++pictures_;
  if (path_.empty() || !c.moment()) return;
  const Moment& m = *c.moment();
  const View& v = c.view();
  const Camera& camera = c.camera.camera();
  Json parameters = Json::object();
  for (const Params::Entry& p : m.params) parameters[p.name] = p.value;
  Json config = Json::object();
  for (const auto& [path, value] : fields_of(m.config)) config[path] = value;
  Json shortcuts = Json::array();
  for (const Binding& b : bindings()) {
    if (*b.shortcut) shortcuts.push_back(b.shortcut);
  }
  Json branches = Json::array(), curves = Json::object();
  for (const History::Branch& b : m.timeline.branches) branches.push_back(b.name);
  if (m.chart) {
    for (const Chart::Curve& curve : m.chart->curves) {
      if (!curve.ghost) curves[curve.name] = curve.points.size();
    }
  }
  float fastest = 0;
  int asleep = 0;
  for (const view::Instance& i : m.scene.instances) {
    fastest = std::max(fastest, i.speed);
    asleep += i.asleep && i.first ? 1 : 0;
  }
  const Quat turn = m.selected ? m.selected->pose.q : Quat{};
  const Json j = {
      {"scene", m.entry->name},
      {"run", m.run},
      {"steps", m.steps},
      {"time", m.time},
      {"paused", v.paused},
      {"speed", v.speed},
      {"rate", v.rate},
      {"bodies", m.bodies},
      {"contacts", m.contacts},
      {"energy", m.energy.total()},
      {"parameters", parameters},
      {"config", config},
      {"selected", c.selected.null() ? -1 : std::int64_t(c.selected.index)},
      {"selected_at", m.selected ? list(m.selected->pose.p) : nullptr},
      {"selected_turn", m.selected ? Json{turn.x, turn.y, turn.z, turn.w} : nullptr},
      {"selected_spin", m.selected ? list(m.selected->spin) : nullptr},
      {"dragging", m.spring.has_value()},
      {"recording", m.recording},
      {"end", m.timeline.end},
      {"branch", m.timeline.here.branch},
      {"branches", branches},
      {"backwards", v.backwards},
      {"ghosts", m.scene.ghosts.size()},
      {"history_bytes", m.timeline.bytes},
      {"curves", curves},
      {"plots", c.plots},
      {"ghost_shown", m.ghost},
      {"abandoned", m.abandoned},
      {"filming", c.filming},
      {"eye", list(camera.eye)},
      {"target", list(camera.target)},
      {"fastest", fastest},
      {"asleep", asleep},
      {"follow", c.follow},
      {"panels", c.panels},
      {"help", c.help},
      {"contacts_shown", c.style.contacts},
      {"joints_shown", c.style.joints},
      {"axes_shown", c.style.axes},
      {"forces_shown", c.style.forces},
      {"boxes_shown", c.style.boxes},
      {"cells_shown", c.style.cells},
      {"labels_shown", c.labels},
      {"sleep_shown", c.style.sleep},
      {"colouring", int(c.style.colouring)},
      {"wireframe", c.style.wireframe},
      {"message", v.message},
      {"messages", v.messages},
      {"pictures", pictures_},
      {"scenes", c.scenes},
      {"fps", frames_per_second},
      {"window", {window.width(), window.height()}},
      {"area", {c.area.x, c.area.y, c.area.width, c.area.height}},
      {"fullscreen", window.fullscreen()},
      {"typing", c.typing},
      {"shortcuts", shortcuts},
      {"places", c.places.all()},
  };
  const std::string text = j.dump() + '\n';
  app::write_file(path_, std::as_bytes(std::span(text)));
}

}
