// Workers that share a loop. for_each(n, task) runs task(worker, i) for every i < n; which worker gets which i is a matter
// of chance, so a task writes only what is its own and results are put together afterwards in the order of i.
//
// Built for machines on which the other workers may not be running at all: the caller works like everybody, takes what
// nobody has taken yet, and waits only for tasks that somebody has begun. Workers look for work for a short while
// (spin), then sleep in the kernel. With one worker there are no threads and no atomic operations.
#pragma once

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <vector>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

class Pool {
 public:
  // At least 1, the caller included. Threads are made when they are first needed.
  explicit Pool(std::uint32_t workers = 1) : workers_(workers) {}
  ~Pool() { stop(); }
  Pool(const Pool&) = delete;
  Pool& operator=(const Pool&) = delete;

  std::uint32_t workers() const { return workers_; }
  void resize(std::uint32_t workers) {
    if (workers == workers_) return;
    stop();
    workers_ = workers;
  }

  // Not from within a task. Tasks do not throw.
  template <class Task>
  void for_each(std::uint32_t n, Task task) {
    if (workers_ == 1 || n <= 1) {
      for (std::uint32_t i = 0; i < n; ++i) task(0u, i);
      return;
    }
    run(n, &task, [](void* t, std::uint32_t worker, std::uint32_t i) { (*static_cast<Task*>(t))(worker, i); });
  }
  // The same for ranges: task(worker, first, end) of at most `grain` each.
  template <class Task>
  void for_ranges(std::uint32_t n, std::uint32_t grain, Task task) {
    for_each((n + grain - 1) / grain, [&](std::uint32_t worker, std::uint32_t k) {
      task(worker, k * grain, std::min(n, (k + 1) * grain));
    });
  }

 private:
  using Call = void (*)(void* task, std::uint32_t worker, std::uint32_t i);

  void run(std::uint32_t n, void* task, Call call);
  void ring(std::uint32_t loop);
  void work(std::uint32_t worker);
  void serve(std::uint32_t worker, std::uint32_t seen);
  void stop();

  std::uint32_t workers_;
  std::vector<std::thread> threads_;
  // A loop's number in the upper half, how many of its tasks nobody has taken in the lower: whoever takes one has
  // taken it from this loop and no other.
  std::atomic<std::uint64_t> open_{0};
  std::atomic<std::uint32_t> loop_{0};  // the number again; changed with the door locked, so that no sleeper misses it
  std::mutex door_;
  std::condition_variable bell_;
  std::atomic<std::uint32_t> left_{0};  // tasks that are not done
  std::atomic<bool> stopping_{false};
  // Of the loop at work; written while it has no tasks.
  std::uint32_t count_ = 0;
  void* task_ = nullptr;
  Call call_ = nullptr;
};

}
