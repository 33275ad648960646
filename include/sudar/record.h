// Recording and replay. A recording is a snapshot, then for every step the operations before it, its dt and hashes of
// what it led to; replay needs no scenario, and names the first difference. A recording that grows in a file is open
// until it gets its end: an open one that was cut off replays up to its last whole step.
#pragma once

#include <sudar/world.h>

#include <span>

namespace sudar::inline SUDAR_PRECISION {

class Recorder {
 public:
  // Starts now: operations on the world are kept from here on, load() like any other. The world may be moved, and must
  // outlive the recorder.
  Recorder(World&, std::string title);
  ~Recorder();                          // stops
  Recorder(const Recorder&) = delete;
  void after_step();                    // call once after every World::step
  Bytes bytes() const;                  // the recording so far, complete: what a file holds
  // The same without an end. It only grows; bytes() differs from it in the first `head` bytes and in its end.
  std::span<const std::byte> open_bytes() const { return data_; }
  static constexpr std::size_t head = 8;

 private:
  World::Impl& world_;
  Bytes data_;
  std::int64_t steps_ = 0;
};

struct Divergence {
  std::int64_t step;
  std::string stage, field;   // the first stage of the step whose hash differs; the first field
  Body body;                  // the first body, null where the difference is not a body's
};

struct RecordingDifference;

class Replay {
 public:
  // Throws Error: not a recording, a version that is not known, cut short. `workers`: as Config's; those of the run that
  // was recorded were its machine's.
  explicit Replay(Bytes recording, std::int32_t workers = 1);
  const std::string& title() const { return title_; }
  std::int64_t steps() const { return steps_; }
  bool done() const;
  bool cut_off() const { return cut_off_; }  // it has no end: these are the whole steps that there are
  World& world() { return world_; }
  const World& world() const { return world_; }
  // Performs the next step; with `check`, compares with the recording.
  std::optional<Divergence> step(bool check = true);
  static bool begins(std::span<const std::byte> file);  // as a recording does

 private:
  friend std::optional<RecordingDifference> difference(Replay&, Replay&);  // difference.h
  struct Step;
  Step begin_step();  // does what was done before it
  void end_step(const Step&);
  Bytes data_;
  std::size_t position_ = 0;
  std::int64_t steps_ = 0, next_ = 0;
  bool cut_off_ = false;
  std::string title_;
  World world_;
};

}
