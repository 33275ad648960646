// What a plot shows of a History: curves over a window of time, as fine as there are pixels, and the marks of the
// timeline. Plain data, independent of the run from then on.
#pragma once

#include <cstdint>

#include "history/history.h"

namespace sudar::history {

struct ChartRequest {
  double from = 0, to = 0;  // simulated, s; to ≤ from: all
  int points = 500;         // a curve, about
  int ghost = -1;           // of this branch as well; −1: none
  bool operator==(const ChartRequest&) const = default;
};

struct Chart {
  struct Point {
    std::int64_t frame;
    double time;  // s
    Span value;
  };
  struct Curve {
    int number;  // of the watch
    std::string name, unit;
    bool ghost = false;
    std::vector<Point> points;
  };
  std::vector<Curve> curves;
  double first = 0, last = 0;       // time of all that is known, s
  std::vector<std::uint8_t> marks;  // Mark's bits, in equal parts of the frames from begin to end
};

constexpr int mark_parts = 600;
Chart chart_of(const History&, const ChartRequest&);

std::string title_of(const Chart::Curve&);  // with its unit

// Files of what is shown, with where it comes from. A row for each frame, or for as many as were merged.
std::string as_csv(const Chart&, const std::vector<std::pair<std::string, std::string>>& provenance);
std::string as_svg(const Chart&, bool logarithmic, const std::vector<std::pair<std::string, std::string>>& provenance);

}
