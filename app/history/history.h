// The course of a run, always kept: one can go back to any step, look, change something and go on from there.
//
// Kept are snapshots of some steps (keyframes) and what a hand did before each step (deeds); every step between is made
// again from the keyframe before it, with the same bits. Memory is bounded however long a run lasts: where there are
// too many keyframes those whose loss costs least are dropped, so that they lie closer near the present; curves are
// thinned (thinned.h); where deeds alone are too many the beginning is forgotten.
//
// Frame k is the state after k steps, and place (k, n) that with the first n deeds before the next step done. Going
// back and on makes the known steps again, deeds included. A new deed where a future is known begins a branch: that
// future stays under its own name, until it is removed. A branch owns the frames from where it leaves its parent.
//
// Rejected: recording World's operations instead of deeds (what a scenario remembers would be lost), and poses of every
// frame (fast to show, but nothing to go on from).
#pragma once

#include <chrono>
#include <limits>

#include "history/quantity.h"
#include "history/run.h"
#include "history/thinned.h"

namespace sudar::history {

using Clock = std::chrono::steady_clock;

// Of one frame, or of some.
struct Span {
  double low = 0, high = 0;
  void merge(const Span& s);  // NaN counts for nothing
};

// What happened in a step.
struct Mark {
  enum Kind : std::uint8_t { touch = 1, hit = 2, sleep = 4, wake = 8, edit = 16, quarantine = 32 };
  std::uint8_t bits = 0;
  void merge(const Mark& m) { bits |= m.bits; }
};

struct Place {
  static constexpr std::size_t all = std::numeric_limits<std::size_t>::max();
  int branch = 0;
  std::int64_t frame = 0;
  std::size_t deeds = all;  // of those before the next step that are done
  bool operator==(const Place&) const = default;
};

struct Limits {
  std::size_t bytes = std::size_t(256) << 20;  // of keyframes
  std::size_t deeds = 100'000;
};

class History {
 public:
  explicit History(std::unique_ptr<Run> start, const Limits& = {});
  ~History();

  Run& run() { return *run_; }  // not to be changed but through deeds: what is not kept is lost
  const Run& run() const { return *run_; }
  Place here() const { return {branch_, frame_, done_}; }

  void step();                // the known next step again, or a new one
  void perform(const Deed&);  // before the next step; throws Error, and has changed nothing then
  // As it was before the first step of this branch, or anew with other settings. What was done since is not repeated:
  // that is a new branch.
  void restart(const Settings&);

  // Goes there, or towards it until `deadline`; true: it is reached. A frame that is not known is the nearest one.
  bool go(Place, Clock::time_point deadline = Clock::time_point::max());
  std::optional<Place> undone() const;  // the place before the last edit; none: there is none
  std::optional<Place> redone() const;  // behind the next one

  struct Branch {
    int number = 0;
    std::string name;
    int parent = -1;        // number; −1: it begins by itself
    std::int64_t from = 0;  // its first frame
    std::int64_t end = 0;   // its last one
    bool removed = false;   // but others go out from it
  };
  std::vector<Branch> branches() const;  // not the removed ones
  const Branch& branch() const;          // the one that the run is in
  std::int64_t begin() const;            // first frame of it that can be gone to
  std::int64_t end() const { return branch().end; }
  void rename(int branch, std::string name);
  void remove(int branch);  // throws Error: it is the one that the run is in
  std::size_t bytes() const;

  // The same frame of another branch, where it has one, for drawing: made beside the run, towards the frame until
  // `deadline`. Null: it is not there.
  const Run* ghost(int branch, Clock::time_point deadline);

  // What is measured after every step, by number. The past is measured as well, by and by: fill().
  int watch(const Quantity&);
  void unwatch(int number);
  struct Watched {
    int number;
    Quantity quantity;
    std::string name, unit;
  };
  const std::vector<Watched>& watched() const { return watched_; }
  bool fill(Clock::time_point deadline);  // true: there is more to do
  // All that is known of it in that branch and those that it comes from, frame by frame, or some frames together.
  struct Sample {
    std::int64_t frame;
    double time;  // simulated, s: of the frame
    Span value;
  };
  std::vector<Sample> curve(int branch, int number) const;
  struct MarkAt {
    std::int64_t frame;
    Mark mark;
  };
  std::vector<MarkAt> marks() const;  // of the branch that the run is in

 private:
  struct Course;  // a branch with all that is kept of it
  struct Made;    // a run that is made again beside the present one
  Course& course(int number);
  const Course& course(int number) const;
  const Course* parent(const Course&) const;
  const Course& root_of(const Course&) const;
  const Course& owner(const Course&, std::int64_t frame) const;  // whose keyframe of that frame it is
  const std::vector<Deed>& deeds_at(const Course&, std::int64_t frame) const;
  Course& add_course(std::string name, int parent, std::int64_t from);
  void begin_alone(std::string name);
  void leave();
  void limit_branches();
  void drop_removed();
  void keep(const Course&, std::int64_t frame, const Run&);
  void thin();
  void forget_beginning();
  std::pair<std::int64_t, const Run::Saved*> keyframe(const Course&, std::int64_t frame) const;  // at or before it
  bool future_known() const;
  void follow_hand();
  void note(Course&, std::int64_t awake_before);
  void add(const Deed&);
  bool on_the_way(const Place& at, const Place& goal) const;
  bool approach(std::unique_ptr<Run>&, Place& at, const Place& goal, Clock::time_point deadline, bool keeps);

  Limits most_;
  std::vector<std::unique_ptr<Course>> courses_;
  int numbers_ = 0;
  std::unique_ptr<Run> run_;
  int branch_ = 0;
  std::int64_t frame_ = 0;
  std::size_t done_ = 0;
  Hold hand_;                 // the keys that are held now
  bool hand_grabs_ = false;   // the drag is the hand's, not one of the past
  bool awake_known_ = false;  // how many bodies were awake after the last step
  std::size_t kept_ = 0;      // bytes of keyframes, about
  std::vector<Watched> watched_;
  int watches_ = 0;
  std::unique_ptr<Made> ghost_, filler_;
};

}
