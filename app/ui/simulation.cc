#include "ui/simulation.h"

#include <algorithm>

namespace sudar::ui {

namespace {

using Seconds = std::chrono::duration<double>;

// At one wake-up: enough for ten times real time at 1 kHz, and short enough that commands are answered at once.
constexpr int most_steps = 500;
constexpr Seconds most_time{0.03};

Clock::duration ticks(double seconds) { return std::chrono::duration_cast<Clock::duration>(Seconds(seconds)); }

}

double View::share(Clock::time_point now) const {
  if (paused || span <= 0 || before->run != after->run) return 1;
  return std::clamp(Seconds(now - since).count() / span, 0.0, 1.0);
}

Simulation::Simulation() : thread_([this] { loop(); }) {}

Simulation::~Simulation() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Simulation::enqueue(std::function<void()> command) {
  {
    const std::lock_guard lock(mutex_);
    commands_.push_back(std::move(command));
  }
  wake_.notify_one();
}

void Simulation::start(const ScenarioEntry& entry, Settings settings) {
  enqueue([this, &entry, settings = std::move(settings)] { begin(entry, settings); });
}

void Simulation::restart() {
  enqueue([this] {
    if (run_) begin_anew(run_->settings().set);
  });
}

void Simulation::restart(const std::map<std::string, double>& parameters) {
  enqueue([this, parameters] {
    if (run_) begin_anew(parameters);
  });
}

void Simulation::pause(bool on) {
  enqueue([this, on] { paused_ = on, single_steps_ = 0, debt_ = 0; });
}

void Simulation::pause_or_run() {
  enqueue([this] { paused_ = !paused_, single_steps_ = 0, debt_ = 0; });
}

void Simulation::change_speed(double (*from)(double)) {
  enqueue([this, from] { speed_ = from(speed_); });
}

void Simulation::set_speed(double speed) {
  enqueue([this, speed] { speed_ = std::clamp(speed, 0.001, 1000.0); });
}

void Simulation::step(int n) {
  enqueue([this, n] { single_steps_ += n; });
}

void Simulation::select(Body body) {
  enqueue([this, body] { selected_ = body; });
}

void Simulation::show(const view::Detail& detail) {
  enqueue([this, detail] { detail_ = detail; });
}

void Simulation::post(Command command) {
  enqueue([this, command = std::move(command)] {
    if (run_) command(*run_);
  });
}

void Simulation::say(std::string text) {
  const std::lock_guard lock(mutex_);
  view_.message = std::move(text);
  ++view_.messages;
}

View Simulation::view() const {
  const std::lock_guard lock(mutex_);
  return view_;
}

void Simulation::fail(const std::string& what) {
  say(what);
  paused_ = true;
}

// Once in a run.
void Simulation::tell_if_abandoned() {
  if (!run_ || abandoned_run_ == runs_ || run_->session().abandoned().empty()) return;
  abandoned_run_ = runs_;
  say("The scenario misses what was removed (" + run_->session().abandoned() +
      "). The world goes on without it: no keys, no checks. R starts anew");
}

void Simulation::begin(const ScenarioEntry& entry, Settings settings) {
  auto fresh = std::make_unique<Run>(entry, std::move(settings));
  if (run_) {
    if (const std::string what = run_->stop_recording(); !what.empty()) say("Recorded: " + what);
  }
  run_ = std::move(fresh);
  forget();
}

void Simulation::begin_anew(const std::map<std::string, double>& parameters) {
  run_->restart(parameters);
  if (run_->recording()) say("From the start; the recording goes on");
  forget();
}

void Simulation::forget() {
  ++runs_;
  selected_ = {};
  single_steps_ = 0;
  debt_ = 0;
}

bool Simulation::perform_commands() {
  std::deque<std::function<void()>> commands;
  {
    const std::lock_guard lock(mutex_);
    commands.swap(commands_);
  }
  for (const auto& command : commands) {
    try {
      command();
    } catch (const std::exception& e) { say(e.what()); }
  }
  return !commands.empty();
}

int Simulation::advance() {
  const Clock::time_point now = Clock::now();
  const double elapsed = Seconds(now - last_).count();
  last_ = now;
  if (!run_) return 0;
  const double dt = run_->session().world().config().dt;
  if (!paused_) debt_ += elapsed * speed_;
  int steps = 0;
  try {
    while (steps < most_steps && Clock::now() - now < most_time && (paused_ ? single_steps_ > 0 : debt_ >= dt)) {
      const Clock::time_point start = Clock::now();
      run_->step();
      step_us_ += 0.1 * (Seconds(Clock::now() - start).count() * 1e6 - step_us_);
      paused_ ? void(--single_steps_) : void(debt_ -= dt);
      ++steps;
    }
  } catch (const std::exception& e) { fail(e.what()); }
  // What was not reached in time is given up.
  debt_ = std::min(debt_, dt);
  return steps;
}

void Simulation::measure(int steps) {
  if (run_) measured_ += steps * run_->session().world().config().dt;
  const double passed = Seconds(Clock::now() - measured_from_).count();
  if (passed < 0.5) return;
  rate_ = measured_ / passed;
  measured_ = 0;
  measured_from_ = Clock::now();
}

std::shared_ptr<Moment> Simulation::moment() const {
  const Session& session = run_->session();
  const World& w = session.world();
  auto m = std::make_shared<Moment>();
  m->entry = &session.entry();
  m->run = runs_;
  m->steps = w.steps();
  m->time = w.time();
  m->scene = app::scene_of(run_->playback(), detail_);
  m->config = w.config();
  m->params = session.params();
  m->keys = session.scenario().keys();
  m->camera = session.scenario().camera();
  m->bodies = w.bodies().size();
  m->joints = w.joints().size();
  m->contacts = std::size_t(w.profile().contacts);
  m->energy = w.energy();
  m->step_us = step_us_;
  m->spring = run_->spring();
  m->recording = run_->recording();
  m->abandoned = !session.abandoned().empty();
  if (w.alive(selected_)) {
    const BodyView b = w[selected_];
    m->selected = {selected_, b.name(),     double(b.mass()), b.kinetic_energy(),
                   b.pose(),  b.velocity(), b.spin(),         b.asleep()};
  }
  return m;
}

// `fresh`: there is something new to show.
void Simulation::publish(bool fresh) {
  std::shared_ptr<const Moment> next = fresh && run_ ? moment() : nullptr;
  const std::lock_guard lock(mutex_);
  view_.paused = paused_;
  view_.speed = speed_;
  view_.rate = rate_;
  if (!next) return;
  const bool moved = view_.after && (view_.after->run != next->run || view_.after->steps != next->steps);
  if (!view_.after || moved) {
    view_.before = view_.after && view_.after->run == next->run ? view_.after : next;
    view_.since = Clock::now();
    const double way = double(next->steps - view_.before->steps) * next->config.dt;
    view_.span = way / std::max(1e-3, rate_ > 0 ? std::min(rate_, speed_) : speed_);
  }
  view_.after = std::move(next);
}

Clock::time_point Simulation::due() const {
  const auto now = Clock::now();
  if (!run_ || paused_) return now + ticks(0.25);
  const double dt = run_->session().world().config().dt;
  return now + ticks(std::clamp((dt - debt_) / speed_, 0.0, 0.25));
}

void Simulation::loop() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait_until(lock, single_steps_ > 0 ? Clock::now() : due(), [&] { return over_ || !commands_.empty(); });
      if (over_) break;
    }
    const bool changed = perform_commands();
    const int steps = advance();
    tell_if_abandoned();
    measure(steps);
    publish(changed || steps > 0);
  }
  if (!run_) return;
  try {
    run_->stop_recording();
  } catch (const std::exception&) {
    // The program ends; there is nobody to tell.
  }
}

}
