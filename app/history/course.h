// Inside of a History: a branch with all that is kept of it.
#pragma once

#include <map>

#include "history/history.h"

namespace sudar::history {

inline std::size_t bytes_of(const Run::Saved& s) {
  return sizeof s + s.session.size() + 64 * (s.settings.set.size() + s.settings.config.size());
}

struct History::Course : Branch {
  Settings settings;                                // of the run that it began with, where it begins by itself
  bool whole = true;                                // its beginning is not forgotten
  bool named = false;                               // by its user
  std::map<std::int64_t, std::vector<Deed>> deeds;  // of its frames, from `from` on
  std::map<std::int64_t, Run::Saved> keyframes;     // before the deeds
  struct Curve {
    Quantity quantity;
    Thinned<Span> past, live;  // measured later, and at once: from where it was first asked for
  };
  std::map<int, Curve> curves;  // by the number of the watch
  Thinned<Span> time;
  Thinned<Mark> marks;  // from `from` on

  std::int64_t first_sample() const { return parent < 0 ? from : from + 1; }  // its parent has measured `from`
  void cut_behind(std::int64_t last) {
    if (last >= end) return;
    end = last;
    deeds.erase(deeds.upper_bound(last), deeds.end());
    keyframes.erase(keyframes.upper_bound(last), keyframes.end());
  }
  void measure(const World& w, std::int64_t frame) {
    time.append({w.time(), w.time()});
    for (auto& [number, curve] : curves) {
      if (curve.live.end() != frame) continue;
      const double v = value(w, curve.quantity);
      curve.live.append({v, v});
    }
  }
  std::size_t bytes() const {
    std::size_t sum = time.bytes() + marks.bytes();
    for (const auto& [frame, list] : deeds) sum += sizeof list + list.size() * sizeof(Deed);
    for (const auto& [frame, saved] : keyframes) sum += bytes_of(saved);
    for (const auto& [number, curve] : curves) sum += curve.past.bytes() + curve.live.bytes();
    return sum;
  }
  std::size_t count_deeds() const {
    std::size_t sum = 0;
    for (const auto& [frame, list] : deeds) sum += list.size();
    return sum;
  }
};

struct History::Made {
  std::unique_ptr<Run> run;
  Place at{-1, 0, 0};
};

}
