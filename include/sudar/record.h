// Recording and replay. A recording is a snapshot, then for every step the operations before it, its dt and hashes of
// what it led to; replay needs no scenario, and names the first difference.
#pragma once

#include <sudar/world.h>

namespace sudar::inline SUDAR_PRECISION {

class Recorder {
 public:
  // Starts now: operations on the world are kept from here on, load() like any other. The world may be moved, and must
  // outlive the recorder.
  Recorder(World&, std::string title);
  ~Recorder();                          // stops
  Recorder(const Recorder&) = delete;
  void after_step();                    // call once after every World::step
  Bytes bytes() const;                  // the recording so far: what a file holds

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

class Replay {
 public:
  explicit Replay(Bytes recording);     // throws Error: not a recording, a version that is not known, cut short
  const std::string& title() const { return title_; }
  std::int64_t steps() const { return steps_; }
  bool done() const;
  World& world() { return world_; }
  const World& world() const { return world_; }
  // Performs the next step; with `check`, compares with the recording.
  std::optional<Divergence> step(bool check = true);

 private:
  Bytes data_;
  std::size_t position_ = 0;
  std::int64_t steps_ = 0, next_ = 0;
  std::string title_;
  World world_;
};

}
