// A run and its history on a thread of its own, paced by the clock with a fixed step. The drawing thread posts
// commands, performed between two steps in their order, and reads moments: immutable, taken after a step. Neither ever
// waits for the other, so that results do not depend on the frame rate. A scene that computes slower than the clock
// falls behind it, openly (View::rate), and never tries to catch up. On a long way back what is reached so far is
// shown.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "ui/moment.h"

namespace sudar::ui {

struct View {
  std::shared_ptr<const Moment> before, after;  // never null once the first run has started
  Clock::time_point since;                      // `after` is shown from here on …
  double span = 0;                              // … reached after this many seconds
  bool paused = false, backwards = false;
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
  void open(const Catalogue&, const std::string& path);  // a file of save(), or of sudar run --save; pauses
  void save(const std::string& path);                    // the run as it is
  void restart();
  void restart(const std::map<std::string, double>& parameters);
  void pause(bool);
  void pause_or_run();
  void set_speed(double);
  void change_speed(double (*from)(double));
  void step(int n);               // of a paused run; negative: back
  void play_backwards();          // as fast as it would run; pauses at the beginning
  void go(std::int64_t frame);    // of this branch, and pauses
  void go_to_branch(int number);  // the same frame of it, or its last one
  void undo();
  void redo();
  void show_ghost(bool);  // of the branch that was left last, or that was chosen
  void show_ghost_of(int branch);
  void perform(Deed);
  void chart(const ChartRequest&);  // what moments hold; its ghost is that of show_ghost()
  void select(Body);                // null: nothing
  void show(const view::Detail&);   // what moments hold
  void say(std::string);

  // Anything else; not called where there is no run. What it throws becomes the message.
  using Command = std::function<void(History&)>;
  void post(Command);

  View view() const;

 private:
  void loop();
  bool perform_commands();  // were there any?
  int advance();            // returns the steps made
  int make_steps(Clock::time_point now);
  bool approach(Clock::time_point now);  // the goal; did anything change?
  void set_goal(const Place&);
  void follow_branch();
  void draw_chart(bool fresh);
  void publish(bool fresh);
  void measure(int steps);
  void enqueue(std::function<void()>);
  void fail(const std::string& what);
  void tell_if_abandoned();
  void begin(std::unique_ptr<Run>);
  void begin_anew(const Settings&);
  void forget();  // what belonged to the run before
  std::shared_ptr<Moment> moment();
  Clock::time_point due() const;

  // Of the physics thread alone.
  std::unique_ptr<History> history_;
  std::optional<Place> goal_;
  bool backwards_ = false, filling_ = false;
  bool ghost_ = true;
  int left_ = -1, branch_ = -1;  // the branch that is the ghost, and the present one
  ChartRequest chart_request_;
  std::shared_ptr<const Chart> chart_;
  Clock::time_point charted_{};
  bool chart_due_ = true;
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
