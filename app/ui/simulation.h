// A Run on a thread of its own, paced by the clock with a fixed step. The drawing thread posts commands, performed
// between two steps in their order, and reads moments: immutable, taken after a step. Neither ever waits for the other,
// so that results do not depend on the frame rate. A scene that computes slower than the clock falls behind it, openly
// (View::rate), and never tries to catch up.
#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "ui/run.h"

namespace sudar::ui {

using Clock = std::chrono::steady_clock;

struct BodyFacts {
  Body body;
  std::string name;
  double mass = 0, energy = 0;
  Pose pose;
  Vec3 velocity, spin;
  bool asleep = false;
};

// A run after one of its steps: what is drawn, and what is told about it.
struct Moment {
  const ScenarioEntry* entry = nullptr;
  std::int64_t run = 0;  // a new number is a new world: nothing is drawn between moments of two runs
  std::int64_t steps = 0;
  double time = 0;  // simulated, s
  view::Scene scene;
  Config config;
  std::vector<Params::Entry> params;
  std::vector<KeyHelp> keys;
  std::optional<Camera> camera;
  std::size_t bodies = 0, joints = 0, contacts = 0;
  Energy energy;
  double step_us = 0;
  std::optional<BodyFacts> selected;
  std::optional<Run::Spring> spring;
  bool recording = false;
  bool abandoned = false;  // by its scenario (session.h)
};

struct View {
  std::shared_ptr<const Moment> before, after;  // never null once the first run has started
  Clock::time_point since;                      // `after` is shown from here on …
  double span = 0;                              // … reached after this many seconds
  bool paused = false;
  double speed = 1, rate = 0;  // wanted and reached: step time per second of the clock
  std::string message;         // what was done last, or went wrong
  std::int64_t messages = 0;   // their number so far

  double share(Clock::time_point now) const;  // of the way from before to after
};

class Simulation {
 public:
  Simulation();
  ~Simulation();
  Simulation(const Simulation&) = delete;

  void start(const ScenarioEntry&, Settings);
  void restart();
  void restart(const std::map<std::string, double>& parameters);
  void pause(bool);
  void pause_or_run();
  void set_speed(double);
  void change_speed(double (*from)(double));
  void step(int n);                // of a paused run
  void select(Body);               // null: nothing
  void show(const view::Detail&);  // what moments hold
  void say(std::string);

  // Anything else; not called where there is no run. What it throws becomes the message.
  using Command = std::function<void(Run&)>;
  void post(Command);

  View view() const;

 private:
  void loop();
  bool perform_commands();  // were there any?
  int advance();            // returns the steps made
  void publish(bool fresh);
  void measure(int steps);
  void enqueue(std::function<void()>);
  void fail(const std::string& what);
  void tell_if_abandoned();
  void begin(const ScenarioEntry&, Settings);
  void begin_anew(const std::map<std::string, double>& parameters);
  void forget();  // what belonged to the run before
  std::shared_ptr<Moment> moment() const;
  Clock::time_point due() const;

  // Of the physics thread alone.
  std::unique_ptr<Run> run_;
  std::int64_t runs_ = 0, abandoned_run_ = 0;  // the last one of that kind
  Body selected_{};
  view::Detail detail_;
  bool paused_ = false;
  int single_steps_ = 0;
  double speed_ = 1, debt_ = 0, step_us_ = 0;
  Clock::time_point last_ = Clock::now(), measured_from_ = last_;
  double measured_ = 0, rate_ = 0;

  // Shared.
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> commands_;
  View view_;
  bool over_ = false;

  std::thread thread_;  // last: it uses all of the above
};

}
