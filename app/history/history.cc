#include "history/history.h"

#include <algorithm>
#include <cmath>

#include "history/course.h"

namespace sudar::history {

namespace {

constexpr std::int64_t between = 10;  // steps between two keyframes of what is new
constexpr std::int64_t stops = 16;    // keyframes on a way back, so that the next steps back are short

bool same(const Settings& a, const Settings& b) {
  return a.set == b.set && a.config == b.config && a.seconds == b.seconds;
}

template <class T>
bool is(const Deed& d) {
  return std::holds_alternative<T>(d);
}

}

History::History(std::unique_ptr<Run> start, const Limits& most) : most_(most), run_(std::move(start)) {
  for (const char* energy : {"total energy", "kinetic energy", "potential energy"}) watch(of_world(energy));
  begin_alone("main");
}

History::~History() = default;

// --- on ---

bool History::future_known() const { return frame_ < end() || done_ < deeds_at(course(branch_), frame_).size(); }

void History::step() {
  if (done_ < deeds_at(course(branch_), frame_).size()) leave();  // what was undone is not done again
  Course& c = course(branch_);
  const bool fresh = frame_ == c.end;
  if (fresh) follow_hand();
  const std::int64_t awake = run_->world().profile().awake;
  run_->step();
  ++frame_, done_ = 0;
  if (fresh) {
    c.end = frame_;
    note(c, awake);
  } else {
    const std::vector<Deed>& known = deeds_at(c, frame_);
    for (; done_ < known.size(); ++done_) run_->perform(known[done_]);
  }
}

// Before a new step: what the hand holds, not what it held when this was made.
void History::follow_hand() {
  if (run_->grabs() && !hand_grabs_) add(Release{});
  if (run_->session().input.all_held() != hand_.keys) add(hand_);
}

// A step that was made for the first time.
void History::note(Course& c, std::int64_t awake_before) {
  const World& w = run_->world();
  c.measure(w, frame_);
  const Events& e = w.events();
  const std::int64_t awake = w.profile().awake;
  Mark m;
  if (!e.begun.empty()) m.bits |= Mark::touch;
  if (!e.hits.empty()) m.bits |= Mark::hit;
  if (!e.quarantined.empty()) m.bits |= Mark::quarantine;
  if (awake_known_ && awake < awake_before) m.bits |= Mark::sleep;
  if (awake_known_ && awake > awake_before) m.bits |= Mark::wake;
  awake_known_ = true;
  c.marks.append(m);
  if (frame_ - keyframe(c, frame_).first < between) return;
  keep(c, frame_, *run_);
  forget_beginning();
}

// --- deeds ---

// Performs it, and keeps it. Of two movements of the mouse between two steps the last one counts.
void History::add(const Deed& deed) {
  run_->perform(deed);
  if (future_known()) leave();
  Course& c = course(branch_);
  std::vector<Deed>& deeds = c.deeds[frame_];
  const bool moves = is<DragTo>(deed) || is<Twist>(deed);
  if (moves && !deeds.empty() && deeds.back().index() == deed.index()) {
    deeds.back() = deed;
  } else {
    deeds.push_back(deed);
  }
  done_ = deeds.size();
  if (is_edit(deed)) {
    Mark m{Mark::edit};
    c.marks.merge_last(m);
    awake_known_ = false;  // it may have woken some
  }
}

void History::perform(const Deed& deed) {
  if (const auto* hold = std::get_if<Hold>(&deed)) {
    const bool presses = std::any_of(hold->keys.begin(), hold->keys.end(), [&](const std::string& key) {
      return std::find(hand_.keys.begin(), hand_.keys.end(), key) == hand_.keys.end();
    });
    hand_ = *hold;
    if (future_known() && !presses) return;  // who lets go of a key while the past is shown changes nothing
  }
  if ((is<DragTo>(deed) || is<Twist>(deed) || is<Release>(deed)) && !hand_grabs_) return;
  add(deed);
  if (is<Grab>(deed)) hand_grabs_ = run_->grabs();
  if (is<Release>(deed)) hand_grabs_ = false;
}

void History::restart(const Settings& settings) {
  const Course& first = root_of(course(branch_));
  if (!same(settings, first.settings) || !first.whole) {
    run_->become(Run(run_->session().entry(), settings));
    hand_grabs_ = awake_known_ = false;
    return begin_alone("");
  }
  const auto touched = [&](const Course& last) {
    const Course* c = &last;
    while (c && c->deeds.empty()) c = parent(*c);
    return c != nullptr;
  };
  const bool as_it_came = !touched(course(branch_));
  go({as_it_came ? branch_ : first.number, first.from, 0});
  if (touched(course(branch_))) leave();
}

std::optional<Place> History::undone() const {
  const Course& c = course(branch_);
  for (std::int64_t frame = frame_; frame >= begin(); --frame) {
    const std::vector<Deed>& deeds = deeds_at(c, frame);
    for (std::size_t i = frame == frame_ ? done_ : deeds.size(); i-- > 0;) {
      if (is_edit(deeds[i])) return Place{branch_, frame, i};
    }
  }
  return {};
}

std::optional<Place> History::redone() const {
  const Course& c = course(branch_);
  for (std::int64_t frame = frame_; frame <= c.end; ++frame) {
    const std::vector<Deed>& deeds = deeds_at(c, frame);
    for (std::size_t i = frame == frame_ ? done_ : 0; i < deeds.size(); ++i) {
      if (!is_edit(deeds[i])) continue;
      const auto next = std::find_if(deeds.begin() + std::ptrdiff_t(i) + 1, deeds.end(), is_edit);
      return Place{branch_, frame, next == deeds.end() ? Place::all : std::size_t(next - deeds.begin())};
    }
  }
  return {};
}

// --- to and fro ---

// Is `at` a part of the past of `goal`?
bool History::on_the_way(const Place& at, const Place& goal) const {
  if (at.frame > goal.frame || (at.frame == goal.frame && at.deeds > goal.deeds)) return false;
  const Course* c = &course(goal.branch);
  for (; c && c->number != at.branch; c = parent(*c)) {
    if (at.frame >= c->from) return false;
  }
  return c != nullptr && (at.frame == goal.frame || at.deeds == deeds_at(*c, at.frame).size());
}

// Makes the steps from a keyframe, or from where it is, to the goal. Its frame exists.
bool History::approach(std::unique_ptr<Run>& run, Place& at, const Place& goal, Clock::time_point deadline,
                       bool keeps) {
  const Course& c = course(goal.branch);
  const auto [frame, saved] = keyframe(c, goal.frame);
  std::int64_t stop = 0;  // frames between keyframes on the way
  if (!run || !on_the_way(at, goal) || at.frame < frame) {
    Run again(run_->session().entry(), *saved);
    if (run) {
      run->become(std::move(again));
    } else {
      run = std::make_unique<Run>(run_->session().entry(), *saved);
    }
    at = {goal.branch, frame, 0};
    stop = std::max<std::int64_t>(1, (goal.frame - frame) / stops);
  }
  at.branch = goal.branch;
  const auto perform = [&] {
    const std::vector<Deed>& deeds = deeds_at(c, at.frame);
    const std::size_t last = at.frame < goal.frame ? deeds.size() : std::min(goal.deeds, deeds.size());
    for (; at.deeds < last; ++at.deeds) run->perform(deeds[at.deeds]);
  };
  perform();
  while (at.frame < goal.frame) {
    run->step();
    ++at.frame, at.deeds = 0;
    if (keeps && stop > 0 && (at.frame - frame) % stop == 0) keep(c, at.frame, *run);
    perform();
    if (at.frame < goal.frame && Clock::now() > deadline) return false;
  }
  return true;
}

bool History::go(Place goal, Clock::time_point deadline) {
  const Course& c = course(goal.branch);
  goal.frame = std::clamp(goal.frame, root_of(c).from, c.end);
  goal.deeds = std::min(goal.deeds, deeds_at(c, goal.frame).size());
  Place at = here();
  hand_grabs_ = awake_known_ = false;
  const bool reached = approach(run_, at, goal, deadline, true);
  branch_ = at.branch, frame_ = at.frame, done_ = at.deeds;
  return reached;
}

const Run* History::ghost(int branch, Clock::time_point deadline) {
  const Course& c = course(branch);
  if (branch == branch_ || frame_ < root_of(c).from || frame_ > c.end) return nullptr;
  if (!ghost_) ghost_ = std::make_unique<Made>();
  const bool reached = approach(ghost_->run, ghost_->at, {branch, frame_, deeds_at(c, frame_).size()}, deadline, false);
  return reached ? ghost_->run.get() : nullptr;
}

}
