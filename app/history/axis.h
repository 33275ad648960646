// One axis of a plot: what it shows, where that is on the paper, and where its ticks are.
#pragma once

#include <string>
#include <vector>

#include "history/chart.h"

namespace sudar::history {

class Axis {
 public:
  Axis(double low, double high, bool logarithmic = false);        // widened where there is nothing between them
  void place(double from, double to) { from_ = from, to_ = to; }  // of low and high, on the paper
  double operator()(double value) const;                          // on the paper
  double value(double at) const;                                  // the other way
  bool shows(double value) const;                                 // it has a place: finite, of a logarithm positive
  std::vector<double> ticks(int about) const;                     // 1, 2 or 5 times a power of ten; powers of ten
  double low() const { return low_; }
  double high() const { return high_; }

 private:
  double low_, high_, from_ = 0, to_ = 1;
  bool logarithmic_;
};

// That shows all of the curves. `shown`: by number of the watch; empty: all.
Axis axis_of(const Chart&, bool logarithmic, const std::vector<int>& shown = {});

std::string text_of(double, int digits = 9);
std::string curve_colour(int number);  // "#rrggbb", the same for the same watch

}
