#include "main/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace sudar::app {

Progress::Progress(std::string title, double total)
    : title_(std::move(title)), total_(total), terminal_(isatty(STDERR_FILENO) == 1) {}

void Progress::clear() {
  if (terminal_) std::fputs("\r\033[K", stderr);
}

void Progress::show(double done) {
  const Clock::time_point now = Clock::now();
  if (!terminal_ || now < next_) return;
  next_ = now + std::chrono::milliseconds(100);
  constexpr int width = 30;
  const double share = total_ > 0 ? std::clamp(done / total_, 0.0, 1.0) : 1;
  const double passed = std::chrono::duration<double>(now - start_).count();
  std::string bar;
  for (int i = 0; i < width; ++i) bar += i < int(share * width) ? "█" : "░";
  std::fprintf(stderr, "\r%-16s %s %3.0f %%", title_.c_str(), bar.c_str(), 100 * share);
  if (share > 0.02) std::fprintf(stderr, "  %.0f s left", passed / share - passed);
  std::fputs("\033[K", stderr);
  std::fflush(stderr);
}

}
