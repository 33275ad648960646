#include "history/run.h"

#include <algorithm>
#include <filesystem>

#include "main/files.h"
#include "main/report.h"

namespace sudar::history {

namespace {

Session loaded(const ScenarioEntry& entry, const Run::Saved& saved) {
  Catalogue catalogue;
  catalogue.add(&entry);
  return Session::load(catalogue, saved.session, saved.workers);
}

}

Run::Run(std::unique_ptr<Session> session, Settings settings)
    : settings_(std::move(settings)), session_(std::move(session)), playback_(app::play(*session_)) {}

Run::Run(const ScenarioEntry& entry, Settings settings) : Run(std::make_unique<Session>(entry, settings), settings) {}

Run::Run(const ScenarioEntry& entry, const Saved& saved)
    : Run(std::make_unique<Session>(loaded(entry, saved)), saved.settings) {
  grabbed_ = saved.grabbed;
  twist_ = saved.twist;
}

Run::Saved Run::save() const { return {session_->save(), settings_, world().config().workers, grabbed_, twist_}; }

void Run::become(Run&& other) {
  if (recording_) {  // the recorder keeps to its world: the other one's state moves in there
    own().load(other.own().save());
    other.own() = std::move(own());
  }
  settings_ = std::move(other.settings_);
  session_ = std::move(other.session_);
  playback_ = app::play(*session_);
  grabbed_ = other.grabbed_;
  twist_ = other.twist_;
}

void Run::step() {
  pull();
  session_->step();
  if (recording_) recording_->after_step();
}

void Run::perform(const Deed& deed) {
  std::visit([&](const auto& d) { act(d); }, deed);
}

void Run::act(const Configure& deed) {
  const auto was = fields_of(world().config()), is = fields_of(deed.config);
  own().set_config(deed.config);
  for (std::size_t i = 0; i < is.size(); ++i) {
    if (is[i] == was[i]) continue;
    std::erase_if(settings_.config, [&](const auto& field) { return field.first == is[i].first; });
    settings_.config.push_back(is[i]);
  }
}

void Run::act(const Hold& deed) {
  session_->input.set(deed.keys);
  session_->input.view = deed.view;
}

namespace {

// The ray's point at a distance along the view: a plane across the picture.
Pos at_depth(const Ray& ray, double depth) {
  return ray.from + ray.direction * Real(depth / dot(ray.direction, ray.forward));
}

constexpr Real reach = Real(1e7);  // of rays, in scenes' scales

// What a hand adds weighs as much as what is there, kg.
Real usual_mass(const World& w) {
  double sum = 0;
  int n = 0;
  for (const Body b : w.bodies()) {
    if (w[b].motion() == Motion::dynamic) sum += double(w[b].mass()), ++n;
  }
  return n > 0 ? Real(sum / n) : 1;
}

}

void Run::act(const Grab& deed) {
  const Body body = deed.body;
  const Ray& ray = deed.ray;
  grabbed_.reset();
  twist_ = {};
  if (!world().alive(body) || world()[body].motion() != Motion::dynamic) return;
  const BodyView view = world()[body];
  // The picture may be a step old: where the ray no longer meets the body, take the ray's point nearest to its centre.
  const auto hit = world().ray_cast(ray.from, ray.direction, reach * view.radius());
  const Pos at =
      hit && hit->body == body ? hit->at : ray.from + ray.direction * dot(view.center() - ray.from, ray.direction);
  grabbed_ = Grabbed{body, view.pose().local(at), double(dot(at - ray.from, ray.forward)), at};
}

void Run::act(const DragTo& deed) {
  if (grabbed_) grabbed_->target = at_depth(deed.ray, grabbed_->depth);
}

void Run::act(const Twist& deed) { twist_ = deed.spin; }

void Run::act(const Release&) {
  grabbed_.reset();
  twist_ = {};
}

std::optional<Run::Spring> Run::spring() const {
  if (!grabbed_ || !world().alive(grabbed_->body)) return {};
  return Spring{world()[grabbed_->body].pose().point(grabbed_->point), grabbed_->target};
}

void Run::pull() {
  if (!grabbed_) return;
  if (!world().alive(grabbed_->body)) return grabbed_.reset();
  const BodyView view = world()[grabbed_->body];
  const Config& config = world().config();
  // The point as a free mass K⁻¹ on a spring of angular frequency ω with damping ratio 1: F = K⁻¹(ω²x − 2ωv). ω is
  // 12 rad/s, less where a step is so long that the constant force of one step would overshoot.
  const Real step = Real(config.dt) * config.time_factor, omega = min(Real(12), Real(0.3) / step);
  const Pos at = view.pose().point(grabbed_->point);
  const Mat3 arm = Mat3::skew(at - view.center());
  const Mat3 mobility = Mat3::identity() * (1 / view.mass()) + arm * inverse(view.inertia()) * transpose(arm);
  const Vec3 wanted = (grabbed_->target - at) * (omega * omega) - view.velocity_at(at) * (2 * omega);
  own().wake(grabbed_->body);
  own().push(grabbed_->body, inverse(mobility) * wanted, at);
  if (twist_ == Vec3{}) return;
  own().twist(grabbed_->body, view.inertia() * ((twist_ - view.spin()) * omega));  // with the same ω
}

void Run::act(const Shoot& deed) {
  const Real radius = Real(0.05 * deed.scale);
  // Crosses the scene in half a second of the run.
  const Vec3 velocity = deed.ray.direction * Real(4 * deed.scale / double(world().config().time_factor));
  own().add({.shape = sphere(radius),
             .at = deed.ray.from + deed.ray.direction * (4 * radius),
             .velocity = velocity,
             .mass = 2 * usual_mass(world()),
             .material = {.restitution = Real(0.3)}});
}

void Run::act(const Insert& deed) {
  const Real size = Real(0.12 * deed.scale);
  const auto hit = world().ray_cast(deed.ray.from, deed.ray.direction, reach * Real(deed.scale));
  const Pos at = hit ? hit->at + hit->normal * (Real(1.2) * size) : at_depth(deed.ray, 3 * deed.scale);
  own().add({.shape = deed.solid == Solid::box ? box({size, size, size}) : sphere(size / 2),
             .at = at,
             .mass = usual_mass(world())});
}

void Run::act(const Remove& deed) {
  if (world().alive(deed.body)) own().remove(deed.body);
}

void Run::start_recording() {
  if (recording_) return;
  const std::string name = session_->entry().name;
  recording_ = std::make_unique<app::Recording>(app::unused_name(name, ".sudar"), own(), name);
}

std::string Run::stop_recording() {
  if (!recording_) return {};
  const std::unique_ptr<app::Recording> done = std::move(recording_);
  done->finish();
  return done->path() + ", " + std::to_string(done->steps()) + " steps, state " + app::hex(world().hash());
}

}
