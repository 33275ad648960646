#include "ui/background.h"

namespace sudar::ui {

Background::~Background() {
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Background::post(std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push_back(std::move(job));
  }
  wake_.notify_one();
}

std::size_t Background::waiting() const {
  const std::lock_guard lock(mutex_);
  return jobs_.size();
}

void Background::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    wake_.wait(lock, [&] { return over_ || !jobs_.empty(); });
    if (jobs_.empty()) return;
    const std::function<void()> job = jobs_.front();
    lock.unlock();
    job();
    lock.lock();
    jobs_.pop_front();
  }
}

}
