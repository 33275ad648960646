#include "base/pool.h"

#include "base/float_state.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

constexpr int spins = 2000;  // some ten microseconds: between two stages of a step, not between two steps

void pause() {
#if defined(__x86_64__) || defined(__i386__)
  __builtin_ia32_pause();
#endif
}

}

void Pool::run(std::uint32_t n, void* task, Call call) {
  while (threads_.size() + 1 < workers_) {
    threads_.emplace_back(&Pool::serve, this, std::uint32_t(threads_.size() + 1), loop_.load());
  }
  count_ = n, task_ = task, call_ = call;
  left_.store(n, std::memory_order_relaxed);
  const std::uint32_t number = loop_.load(std::memory_order_relaxed) + 1;
  open_.store(std::uint64_t(number) << 32 | n, std::memory_order_release);
  ring(number);
  work(0);
  // Whoever took a task is running: it is not long now.
  for (int spin = 0; left_.load(std::memory_order_acquire) != 0; ++spin) {
    if (spin < spins) pause();
    else std::this_thread::yield();
  }
}

void Pool::ring(std::uint32_t loop) {
  {
    const std::lock_guard lock(door_);
    loop_.store(loop, std::memory_order_release);
  }
  bell_.notify_all();
}

// Takes tasks while there are any.
void Pool::work(std::uint32_t worker) {
  std::uint64_t open = open_.load(std::memory_order_acquire);
  while ((open & 0xffffffffu) != 0) {
    if (!open_.compare_exchange_weak(open, open - 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
    // The loop cannot end before this task is done, so what it is made of stands still.
    call_(task_, worker, count_ - std::uint32_t(open & 0xffffffffu));
    left_.fetch_sub(1, std::memory_order_acq_rel);
    open = open_.load(std::memory_order_acquire);
  }
}

void Pool::serve(std::uint32_t worker, std::uint32_t seen) {
  const FloatState defaults;
  while (true) {
    for (int spin = 0; spin < spins && loop_.load(std::memory_order_acquire) == seen; ++spin) pause();
    if (loop_.load(std::memory_order_acquire) == seen) {
      std::unique_lock lock(door_);
      bell_.wait(lock, [&] { return loop_.load(std::memory_order_acquire) != seen; });
    }
    seen = loop_.load(std::memory_order_acquire);
    if (stopping_.load(std::memory_order_acquire)) return;
    work(worker);
  }
}

void Pool::stop() {
  stopping_.store(true, std::memory_order_release);
  ring(loop_.load(std::memory_order_relaxed) + 1);
  for (std::thread& t : threads_) t.join();
  threads_.clear();
  stopping_.store(false, std::memory_order_release);
}

}
