#include "ui/run.h"

#include <algorithm>
#include <filesystem>

#include "main/files.h"
#include "main/report.h"

namespace sudar::ui {

Run::Run(const ScenarioEntry& entry, Settings settings) : settings_(std::move(settings)) {
  take(std::make_unique<Session>(entry, settings_));
}

void Run::take(std::unique_ptr<Session> session) {
  session_ = std::move(session);
  playback_ = app::play(*session_);
}

void Run::restart(const std::map<std::string, double>& parameters) {
  Settings settings = settings_;
  settings.set = parameters;
  auto fresh = std::make_unique<Session>(session_->entry(), settings);
  if (recording_) {  // the recorder keeps to its world: the new one's state moves in there
    world().load(fresh->world().save());
    fresh->world() = std::move(world());
  }
  fresh->input = session_->input;  // what is held stays held
  release();
  settings_ = std::move(settings);
  take(std::move(fresh));
}

void Run::step() {
  pull();
  session_->step();
  if (recording_) recording_->after_step();
}

void Run::set_config(const Config& config) {
  const auto was = fields_of(world().config()), is = fields_of(config);
  world().set_config(config);
  for (std::size_t i = 0; i < is.size(); ++i) {
    if (is[i] == was[i]) continue;
    std::erase_if(settings_.config, [&](const auto& field) { return field.first == is[i].first; });
    settings_.config.push_back(is[i]);
  }
}

void Run::hold(std::vector<std::string> keys, const Vec3& view) {
  session_->input.set(std::move(keys));
  session_->input.view = view;
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

void Run::grab(Body body, const Ray& ray) {
  grabbed_.reset();
  if (!world().alive(body) || world()[body].motion() != Motion::dynamic) return;
  const BodyView view = world()[body];
  // The picture may be a step old: where the ray no longer meets the body, take the ray's point nearest to its centre.
  const auto hit = world().ray_cast(ray.from, ray.direction, reach * view.shape().bounding_radius());
  const Pos at =
      hit && hit->body == body ? hit->at : ray.from + ray.direction * dot(view.center() - ray.from, ray.direction);
  grabbed_ = Grab{body, view.pose().local(at), double(dot(at - ray.from, ray.forward)), at};
}

void Run::drag_to(const Ray& ray) {
  if (grabbed_) grabbed_->target = at_depth(ray, grabbed_->depth);
}

std::optional<Run::Spring> Run::spring() const {
  if (!grabbed_ || !session_->world().alive(grabbed_->body)) return {};
  return Spring{session_->world()[grabbed_->body].pose().point(grabbed_->point), grabbed_->target};
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
  world().wake(grabbed_->body);
  world().push(grabbed_->body, inverse(mobility) * wanted, at);
  if (twist_ == Vec3{}) return;
  world().twist(grabbed_->body, view.inertia() * ((twist_ - view.spin()) * omega));  // with the same ω
}

Body Run::shoot(const Ray& ray, double scale) {
  const Real radius = Real(0.05 * scale);
  // Crosses the scene in half a second of the run.
  const Vec3 velocity = ray.direction * Real(4 * scale / double(world().config().time_factor));
  const Body ball = world().add({.shape = sphere(radius),
                                 .at = ray.from + ray.direction * (4 * radius),
                                 .velocity = velocity,
                                 .mass = 2 * usual_mass(world()),
                                 .material = {.restitution = Real(0.3)}});
  return ball;
}

Body Run::insert(Solid solid, const Ray& ray, double scale) {
  const Real size = Real(0.12 * scale);
  const auto hit = world().ray_cast(ray.from, ray.direction, reach * Real(scale));
  const Pos at = hit ? hit->at + hit->normal * (Real(1.2) * size) : at_depth(ray, 3 * scale);
  return world().add({.shape = solid == Solid::box ? box({size, size, size}) : sphere(size / 2),
                      .at = at,
                      .mass = usual_mass(world())});
}

void Run::remove(Body body) {
  if (world().alive(body)) world().remove(body);
}

void Run::start_recording() {
  if (recording_) return;
  const std::string name = session_->entry().name;
  recording_ = std::make_unique<app::Recording>(app::unused_name(name, ".sudar"), world(), name);
}

std::string Run::stop_recording() {
  if (!recording_) return {};
  const std::unique_ptr<app::Recording> done = std::move(recording_);
  done->finish();
  return done->path() + ", " + std::to_string(done->steps()) + " steps, state " + app::hex(world().hash());
}

}
