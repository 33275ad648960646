// Many worlds that have nothing to do with each other, stepped side by side: for learning, sweeps and studies.
//   Batch batch;
//   batch.step(worlds, 100);
// Each world gets the bits that it would get alone.
#pragma once

#include <sudar/world.h>

#include <memory>
#include <span>

namespace sudar::inline SUDAR_PRECISION {

class Batch {
 public:
  explicit Batch(std::int32_t threads = 0);  // the caller's included; 0: as many as the machine has. Throws Error
  Batch(Batch&&) noexcept;
  Batch& operator=(Batch&&) noexcept;
  ~Batch();
  std::int32_t threads() const;
  // Every world by config().dt, `steps` times. Worlds of their own `workers` wait for them; one thread each is best.
  // Throws what the first of the worlds threw, when all others are done.
  void step(std::span<World* const> worlds, std::int64_t steps = 1);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}
