#include "ui/moment.h"

namespace sudar::ui {

namespace {

Timeline timeline_of(const History& h) {
  return {h.here(), h.begin(), h.end(), h.branches(), h.bytes(), h.undone().has_value(), h.redone().has_value()};
}

std::vector<Related> related_to(const World& w, Body body) {
  std::vector<Related> all;
  for (const Joint j : w.joints()) {
    const bool of_it = std::visit([&](const auto& d) { return d.a == body || d.b == body; }, w[j].definition());
    if (of_it) all.push_back({"Joint " + std::to_string(j.index), {.of = Quantity::Of::joint, .joint = j}});
  }
  for (const Contact& c : w.contacts()) {
    if (c.a != body && c.b != body) continue;
    const Body other = c.a == body ? c.b : c.a;
    const std::string name = w[other].name().empty() ? "body " + std::to_string(other.index) : w[other].name();
    all.push_back({"Contact with " + name, {.of = Quantity::Of::contact, .a = body, .b = other}});
  }
  return all;
}

}

Moment moment_of(const History& h, const view::Detail& detail, Body selected, const Run* ghost) {
  const Run& run = h.run();
  const Session& session = run.session();
  const World& w = session.world();
  Moment m;
  m.entry = &session.entry();
  m.steps = w.steps();
  m.time = w.time();
  m.scene = app::scene_of(run.playback(), detail);
  if (ghost) view::add_ghosts(m.scene, app::scene_of(ghost->playback()));
  m.config = w.config();
  m.params = session.params();
  m.keys = session.scenario().keys();
  m.camera = session.scenario().camera();
  m.bodies = w.bodies().size();
  m.joints = w.joints().size();
  m.contacts = w.contacts().size();
  m.energy = w.energy();
  m.spring = run.spring();
  m.recording = run.recording();
  m.abandoned = !session.abandoned().empty();
  m.timeline = timeline_of(h);
  if (w.alive(selected)) {
    const BodyView b = w[selected];
    m.selected = {selected, b.name(),     double(b.mass()), b.kinetic_energy(),
                  b.pose(), b.velocity(), b.spin(),         b.asleep()};
    m.related = related_to(w, selected);
  }
  return m;
}

}
