#include "ui/simulation.h"

#include <algorithm>

#include "main/files.h"

namespace sudar::ui {

namespace {

using Seconds = std::chrono::duration<double>;

// At one wake-up: enough for ten times real time at 1 kHz, and short enough that commands are answered at once.
constexpr int most_steps = 500;
constexpr Seconds most_time{0.03};
constexpr Seconds chart_every{0.05};  // while something changes
constexpr Seconds spare_time{0.004};  // at one wake-up, for the past of new curves
constexpr Seconds ghost_time{0.025};  // to follow

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
  enqueue([this, &entry, settings = std::move(settings)] { begin(std::make_unique<Run>(entry, settings)); });
}

void Simulation::open(const Catalogue& catalogue, const std::string& path) {
  enqueue([this, &catalogue, path] {
    auto session = std::make_unique<Session>(
        app::load_file(path, [&](const Bytes& bytes) { return Session::load(catalogue, bytes); }));
    Settings settings{.config = fields_of(session->world().config())};
    for (const Params::Entry& p : session->params()) settings.set[p.name] = p.value;
    begin(std::make_unique<Run>(std::move(session), settings));
    paused_ = true;
    say("Opened: " + path);
  });
}

void Simulation::save(const std::string& path) {
  post([this, path](History& h) {
    app::write_file(path, h.run().session().save());
    say("Saved: " + path);
  });
}

void Simulation::restart() {
  enqueue([this] {
    if (history_) begin_anew(history_->run().settings());
  });
}

void Simulation::restart(const std::map<std::string, double>& parameters) {
  enqueue([this, parameters] {
    if (!history_) return;
    Settings settings = history_->run().settings();
    settings.set = parameters;
    begin_anew(settings);
  });
}

void Simulation::pause(bool on) {
  enqueue([this, on] { paused_ = on, backwards_ = false, single_steps_ = 0, debt_ = 0; });
}

void Simulation::pause_or_run() {
  enqueue([this] { paused_ = !paused_, backwards_ = false, single_steps_ = 0, debt_ = 0, goal_.reset(); });
}

void Simulation::play_backwards() {
  enqueue([this] { paused_ = backwards_ && !paused_, backwards_ = true, single_steps_ = 0, debt_ = 0; });
}

void Simulation::change_speed(double (*from)(double)) {
  enqueue([this, from] { speed_ = from(speed_); });
}

void Simulation::set_speed(double speed) {
  enqueue([this, speed] { speed_ = std::clamp(speed, 0.001, 1000.0); });
}

void Simulation::step(int n) {
  enqueue([this, n] {
    backwards_ = false;
    single_steps_ += n;  // those that are not made yet and those back cancel each other
    const int back = std::min(0, single_steps_);
    single_steps_ -= back;
    if (back == 0 || !history_) return;
    Place to = goal_ ? *goal_ : history_->here();
    to.frame = std::max(history_->begin(), to.frame + back), to.deeds = Place::all;
    set_goal(to);
  });
}

void Simulation::set_goal(const Place& place) {
  goal_ = place;
  paused_ = true, backwards_ = false, single_steps_ = 0, debt_ = 0;
}

void Simulation::go(std::int64_t frame) {
  enqueue([this, frame] {
    if (history_) set_goal({history_->here().branch, frame});
  });
}

void Simulation::go_to_branch(int number) {
  enqueue([this, number] {
    if (history_) set_goal({number, history_->here().frame});
  });
}

void Simulation::undo() {
  enqueue([this] {
    const auto place = history_ ? history_->undone() : std::nullopt;
    place ? set_goal(*place) : say("There is nothing to undo");
  });
}

void Simulation::redo() {
  enqueue([this] {
    const auto place = history_ ? history_->redone() : std::nullopt;
    place ? set_goal(*place) : say("There is nothing to redo");
  });
}

void Simulation::show_ghost(bool on) {
  enqueue([this, on] { ghost_ = on, chart_due_ = true; });
}

void Simulation::show_ghost_of(int branch) {
  enqueue([this, branch] { left_ = branch, ghost_ = chart_due_ = true; });
}

void Simulation::perform(Deed deed) {
  enqueue([this, deed = std::move(deed)] {
    if (!history_) return;
    history_->perform(deed);
    if (is_edit(deed)) goal_.reset();
  });
}

void Simulation::chart(const ChartRequest& request) {
  enqueue([this, request] { chart_request_ = request, chart_due_ = true; });
}

void Simulation::select(Body body) {
  enqueue([this, body] { selected_ = body; });
}

void Simulation::show(const view::Detail& detail) {
  enqueue([this, detail] { detail_ = detail; });
}

void Simulation::post(Command command) {
  enqueue([this, command = std::move(command)] {
    if (history_) command(*history_), chart_due_ = true;
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
  if (!history_ || abandoned_run_ == runs_ || history_->run().session().abandoned().empty()) return;
  abandoned_run_ = runs_;
  say("The scenario misses what was removed (" + history_->run().session().abandoned() +
      "). The world goes on without it: no keys, no checks. R starts anew, Ctrl+Z goes back");
}

void Simulation::begin(std::unique_ptr<Run> run) {
  auto fresh = std::make_unique<History>(std::move(run));
  if (history_) {
    if (const std::string what = history_->run().stop_recording(); !what.empty()) say("Recorded: " + what);
  }
  history_ = std::move(fresh);
  left_ = -1, branch_ = history_->here().branch;
  forget();
}

void Simulation::begin_anew(const Settings& settings) {
  history_->restart(settings);
  if (history_->run().recording()) say("From the start; the recording goes on");
  forget();
}

void Simulation::forget() {
  ++runs_;
  selected_ = {};
  single_steps_ = 0;
  debt_ = 0;
  goal_.reset();
  backwards_ = false;
  chart_due_ = true;
}

// The branch that was left is the ghost.
void Simulation::follow_branch() {
  const int now = history_->here().branch;
  if (now != branch_) left_ = branch_, branch_ = now, chart_due_ = true;
  const std::vector<History::Branch> all = history_->branches();
  const auto there = [&](const History::Branch& b) { return b.number == left_ && b.number != now; };
  if (std::none_of(all.begin(), all.end(), there)) left_ = -1;
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

bool Simulation::approach(Clock::time_point now) {
  if (!goal_) return false;
  const Place before = history_->here();
  if (history_->go(*goal_, now + std::chrono::duration_cast<Clock::duration>(most_time))) goal_.reset();
  return history_->here() != before || !goal_;
}

int Simulation::make_steps(Clock::time_point now) {
  const double dt = history_->run().world().config().dt;
  if (!paused_) debt_ += Seconds(now - last_).count() * speed_;
  if (backwards_ && !paused_) {
    const auto steps = std::min(std::int64_t(debt_ / dt), history_->here().frame - history_->begin());
    debt_ -= double(steps) * dt;
    if (history_->here().frame <= history_->begin()) paused_ = true, backwards_ = false;
    if (steps > 0) history_->go({history_->here().branch, history_->here().frame - steps});
    return int(steps);
  }
  int steps = 0;
  while (steps < most_steps && Clock::now() - now < most_time && (paused_ ? single_steps_ > 0 : debt_ >= dt)) {
    const Clock::time_point start = Clock::now();
    history_->step();
    step_us_ += 0.1 * (Seconds(Clock::now() - start).count() * 1e6 - step_us_);
    paused_ ? void(--single_steps_) : void(debt_ -= dt);
    ++steps;
  }
  return steps;
}

int Simulation::advance() {
  const Clock::time_point now = Clock::now();
  int steps = 0;
  if (history_) {
    try {
      steps = approach(now) ? 1 : goal_ ? 0 : make_steps(now);
      // What was not reached in time is given up.
      debt_ = std::min(debt_, history_->run().world().config().dt);
      filling_ = (paused_ || debt_ <= 0.5 * history_->run().world().config().dt) &&
                 history_->fill(now + ticks(spare_time.count()));
    } catch (const std::exception& e) { fail(e.what()), goal_.reset(), filling_ = false; }
    follow_branch();
  }
  last_ = now;
  return steps;
}

void Simulation::measure(int steps) {
  if (history_) measured_ += steps * history_->run().world().config().dt;
  const double passed = Seconds(Clock::now() - measured_from_).count();
  if (passed < 0.5) return;
  rate_ = measured_ / passed;
  measured_ = 0;
  measured_from_ = Clock::now();
}

std::shared_ptr<Moment> Simulation::moment() {
  const Run* ghost = ghost_ && left_ >= 0 ? history_->ghost(left_, Clock::now() + ticks(ghost_time.count())) : nullptr;
  auto m = std::make_shared<Moment>(moment_of(*history_, detail_, selected_, ghost));
  m->run = runs_;
  m->step_us = step_us_;
  m->ghost = ghost_;
  m->ghost_of = left_;
  m->chart = chart_;
  return m;
}

void Simulation::draw_chart(bool fresh) {
  chart_due_ = chart_due_ || fresh || filling_;
  if (!chart_due_ || !history_ || Clock::now() - charted_ < chart_every) return;
  ChartRequest request = chart_request_;
  request.ghost = ghost_ ? left_ : -1;
  chart_ = std::make_shared<Chart>(chart_of(*history_, request));
  charted_ = Clock::now();
  chart_due_ = false;
}

// `fresh`: there is something new to show.
void Simulation::publish(bool fresh) {
  std::shared_ptr<const Moment> next = fresh && history_ ? moment() : nullptr;
  const std::lock_guard lock(mutex_);
  view_.paused = paused_;
  view_.backwards = backwards_ && !paused_;
  view_.speed = speed_;
  view_.rate = rate_;
  if (!next) return;
  const bool moved = view_.after && (view_.after->run != next->run || view_.after->steps != next->steps);
  if (!view_.after || moved) {
    view_.before = view_.after && view_.after->run == next->run ? view_.after : next;
    view_.since = Clock::now();
    const double way = std::abs(double(next->steps - view_.before->steps)) * next->config.dt;
    view_.span = way / std::max(1e-3, rate_ > 0 ? std::min(rate_, speed_) : speed_);
  }
  view_.after = std::move(next);
}

Clock::time_point Simulation::due() const {
  const auto now = Clock::now();
  if (filling_) return now;
  if (chart_due_) return now + ticks(chart_every.count());
  if (!history_ || paused_) return now + ticks(0.25);
  const double dt = history_->run().world().config().dt;
  return now + ticks(std::clamp((dt - debt_) / speed_, 0.0, 0.25));
}

void Simulation::loop() {
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      wake_.wait_until(lock, single_steps_ > 0 || goal_ ? Clock::now() : due(),
                       [&] { return over_ || !commands_.empty(); });
      if (over_) break;
    }
    const bool changed = perform_commands();
    const int steps = advance();
    tell_if_abandoned();
    measure(steps);
    const auto shown = chart_;
    draw_chart(changed || steps > 0);
    publish(changed || steps > 0 || chart_ != shown);
  }
  if (!history_) return;
  try {
    history_->run().stop_recording();
  } catch (const std::exception&) {
    // The program ends; there is nobody to tell.
  }
}

}
