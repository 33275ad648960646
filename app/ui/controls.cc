#include "ui/controls.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace sudar::ui {

using namespace view;

namespace {

// The speeds that + and − walk through.
constexpr std::array speeds = {0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0};

double faster(double speed) {
  const auto next = std::upper_bound(speeds.begin(), speeds.end(), speed * 1.001);
  return next == speeds.end() ? speeds.back() : *next;
}

double slower(double speed) {
  const auto next = std::lower_bound(speeds.begin(), speeds.end(), speed * 0.999);
  return next == speeds.begin() ? speeds.front() : *(next - 1);
}

// Is `name` one of the words of "left, right"?
bool has_word(std::string_view text, std::string_view name) {
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && std::isalnum(static_cast<unsigned char>(text[end]))) ++end;
    if (text.substr(i, end - i) == name) return true;
    i = end + 1;
  }
  return false;
}

}

void Controls::start(const ScenarioEntry& entry) { simulation_.start(entry, {}); }

void Controls::restart_with(const std::map<std::string, double>& parameters) { simulation_.restart(parameters); }

void Controls::neighbour(int way) {
  const auto& all = catalogue_.all();
  if (!moment() || all.empty()) return;
  const auto here = std::find(all.begin(), all.end(), moment()->entry) - all.begin();
  const auto n = std::ptrdiff_t(all.size());
  start(*all[std::size_t((here + way + n) % n)]);
}

void Controls::toggle_recording() {
  Simulation& s = simulation_;
  s.post([&s](History& h) {
    Run& r = h.run();
    if (r.recording()) return s.say("Recorded: " + r.stop_recording());
    r.start_recording();
    s.say("Recording");
  });
}

std::optional<Pos> Controls::place_of(Body b) const {
  for (const Instance& i : scene.instances) {
    if (!b.null() && i.body == b) return i.pose.p;
  }
  return {};
}

bool* Controls::switched_by(Action action) {
  switch (action) {
    case Action::follow:
      return &follow;
    case Action::plots:
      return &plots;
    case Action::contacts:
      return &style.contacts;
    case Action::joints:
      return &style.joints;
    case Action::forces:
      return &style.forces;
    case Action::labels:
      return &labels;
    case Action::boxes:
      return &style.boxes;
    case Action::cells:
      return &style.cells;
    case Action::wireframe:
      return &style.wireframe;
    case Action::axes:
      return &style.axes;
    case Action::sleep:
      return &style.sleep;
    case Action::panels:
      return &panels;
    case Action::help:
      return &help;
    default:
      return nullptr;
  }
}

void Controls::perform(Action action) {
  Simulation& s = simulation_;
  const double scale = focus.radius;
  const Ray ray = pointer;
  if (bool* on = switched_by(action)) *on = !*on;
  switch (action) {
    case Action::open:
      wants_open = true;
      return;
    case Action::save:
      wants_save = moment() != nullptr;
      return;
    case Action::pause:
      return s.pause_or_run();
    case Action::step:
      return s.pause(true), s.step(1);
    case Action::ten_steps:
      return s.pause(true), s.step(10);
    case Action::step_back:
      return s.step(-1);
    case Action::ten_steps_back:
      return s.step(-10);
    case Action::play_backwards:
      return s.play_backwards();
    case Action::newest:
      if (moment()) s.go(moment()->timeline.end);
      return;
    case Action::restart:
      return s.restart();
    case Action::faster:
      return s.change_speed(faster);
    case Action::slower:
      return s.change_speed(slower);
    case Action::real_time:
      return s.set_speed(1);
    case Action::previous:
      return neighbour(-1);
    case Action::next:
      return neighbour(1);
    case Action::search:
      panels = wants_search = true;
      return;
    case Action::frame_selection:
      if (const auto at = place_of(selected)) return camera.frame(*at, 0.3 * scale);
      return camera.set(framing(scene, aspect_));
    case Action::frame_all:
      return camera.set(framing(scene, aspect_));
    case Action::shoot:
      return s.perform(Shoot{ray, scale});
    case Action::add_box:
      return s.perform(Insert{Solid::box, ray, scale});
    case Action::add_sphere:
      return s.perform(Insert{Solid::sphere, ray, scale});
    case Action::remove:
      if (!selected.null()) s.perform(Remove{selected});
      return;
    case Action::undo:
      return s.undo();
    case Action::redo:
      return s.redo();
    case Action::ghost:
      return s.show_ghost(!moment() || !moment()->ghost);
    case Action::colours:
      style.colouring = Colouring((int(style.colouring) + 1) % 4);
      return;
    case Action::fullscreen:
      wants_fullscreen = true;
      return;
    case Action::screenshot:
      wants_screenshot = true;
      return;
    case Action::movie:
      wants_movie = true;
      return;
    case Action::record:
      return toggle_recording();
    case Action::cancel:
      help = follow = false;
      return select({});
    case Action::quit:
      wants_quit = true;
      return;
    case Action::follow:
    case Action::plots:
    case Action::contacts:
    case Action::joints:
    case Action::forces:
    case Action::labels:
    case Action::boxes:
    case Action::cells:
    case Action::wireframe:
    case Action::axes:
    case Action::sleep:
    case Action::panels:
    case Action::help:
      return;  // switched_by
  }
}

bool Controls::belongs_to_scenario(int key) const {
  const std::string name = key_name(key);
  if (name.empty() || !moment() || view_.paused) return false;
  const auto& keys = moment()->keys;
  return std::any_of(keys.begin(), keys.end(), [&](const KeyHelp& k) { return has_word(k.key, name); });
}

void Controls::key(int key, bool down) {
  const std::string name = key_name(key);
  if (name.empty() || (down && !belongs_to_scenario(key))) return;
  const bool was = std::erase(held_, name) > 0;
  if (down) held_.push_back(name);
  if (was != down) hold();
}

void Controls::hold() {
  const Vec3 forward = normalize(camera.camera().target - camera.camera().eye);
  simulation_.perform(Hold{held_, forward});
}

void Controls::look(View v, double aspect) {
  if (const Detail needed = needed_for(style); needed != shown_) simulation_.show(needed), shown_ = needed;
  view_ = std::move(v);
  aspect_ = aspect;
  if (!view_.after) return;
  const Moment& m = *view_.after;
  const double share = view_.share(Clock::now());
  if (view_.after != mixed_ || share != share_) {
    scene = mix(view_.before->scene, m.scene, share);
    mixed_ = view_.after, share_ = share;
    ++scenes;
  }
  if (m.run != seen_run_) {
    // The same scenario again keeps the camera: its user has chosen it.
    if (seen_entry_ != m.entry) {
      camera.set(m.camera && !unset(*m.camera) ? *m.camera : framing(scene, aspect));
      focus = focus_of(scene);
      follow = false;
    }
    seen_run_ = m.run;
    seen_entry_ = m.entry;
    selected = {};
    if (!held_.empty()) hold();
  }
  if (!selected.null() && !place_of(selected)) selected = {};
  if (follow) {
    if (const auto at = place_of(selected)) camera.look_at(*at);
  }
}

}
