#include <sudar/batch.h>

#include <exception>

#include "base/pool.h"

namespace sudar::inline SUDAR_PRECISION {

struct Batch::Impl {
  Pool pool;
  std::vector<std::exception_ptr> failures;  // by world
};

Batch::Batch(std::int32_t threads) : impl_(std::make_unique<Impl>()) {
  if (threads < 0 || threads > 256)
    throw Error("threads", "is " + std::to_string(threads) + ", must be within 0 and 256");
  impl_->pool.resize(threads > 0 ? std::uint32_t(threads) : max(1u, std::thread::hardware_concurrency()));
}
Batch::Batch(Batch&&) noexcept = default;
Batch& Batch::operator=(Batch&&) noexcept = default;
Batch::~Batch() = default;

std::int32_t Batch::threads() const { return std::int32_t(impl_->pool.workers()); }

void Batch::step(std::span<World* const> worlds, std::int64_t steps) {
  auto& failures = impl_->failures;
  failures.assign(worlds.size(), nullptr);
  impl_->pool.for_each(std::uint32_t(worlds.size()), [&](std::uint32_t, std::uint32_t i) {
    try {
      for (std::int64_t n = 0; n < steps; ++n) worlds[i]->step();
    } catch (...) { failures[i] = std::current_exception(); }
  });
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}
