// A thread for what takes long and nobody waits for: pictures and movies are packed and written there, one job after
// the other.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace sudar::ui {

class Background {
 public:
  Background() : thread_([this] { work(); }) {}
  ~Background();  // does what is left
  Background(const Background&) = delete;
  void post(std::function<void()>);  // which throws nothing
  std::size_t waiting() const;       // jobs that are not done

 private:
  void work();
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  std::deque<std::function<void()>> jobs_;  // the first is being done
  bool over_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}
