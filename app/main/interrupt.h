// SIGINT and SIGTERM as a wish. While an Interrupt lives they end nothing: whoever makes steps asks between two of them,
// ends what it writes and says so. A second one ends the program at once.
#pragma once

namespace sudar::app {

inline constexpr int interrupted = 130;  // the exit code, as of a shell after SIGINT

class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  bool wished() const;
};

}
