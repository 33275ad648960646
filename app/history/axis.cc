#include "history/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sudar::history {

Axis::Axis(double low, double high, bool logarithmic) : low_(low), high_(high), logarithmic_(logarithmic) {
  if (logarithmic_) {
    if (!(low_ > 0)) low_ = high_ > 0 ? high_ * 1e-6 : 1e-6;
    if (!(high_ > low_)) high_ = low_ * 10;
    return;
  }
  // Differences that are only rounding look like that.
  const double least = std::max(1e-9 * std::max(std::abs(low_), std::abs(high_)), 1e-12);
  if (!(high_ - low_ > least)) {
    const double middle = (low_ + high_) / 2, half = std::max(0.05 * std::abs(middle), 1e-6);
    low_ = middle - half, high_ = middle + half;
  }
}

double Axis::operator()(double v) const {
  const double share = logarithmic_ ? std::log(v / low_) / std::log(high_ / low_) : (v - low_) / (high_ - low_);
  return from_ + share * (to_ - from_);
}

double Axis::value(double at) const {
  const double share = (at - from_) / (to_ - from_);
  return logarithmic_ ? low_ * std::pow(high_ / low_, share) : low_ + share * (high_ - low_);
}

bool Axis::shows(double v) const { return std::isfinite(v) && (!logarithmic_ || v > 0); }

std::vector<double> Axis::ticks(int about) const {
  std::vector<double> all;
  if (logarithmic_) {
    const double decades = std::log10(high_ / low_);
    const double step = std::max(1.0, std::ceil(decades / about));
    for (double e = std::ceil(std::log10(low_) - 1e-9); e <= std::log10(high_) + 1e-9; e += step) {
      all.push_back(std::pow(10, e));
    }
    return all;
  }
  const double raw = (high_ - low_) / about, power = std::pow(10, std::floor(std::log10(raw))), digit = raw / power;
  const double step = power * (digit > 5 ? 10 : digit > 2 ? 5 : digit > 1 ? 2 : 1);
  for (double n = std::ceil(low_ / step - 1e-9); n * step <= high_ + 1e-9 * step; ++n)
    all.push_back(n * step + 0.0);  // no −0
  return all;
}

Axis axis_of(const Chart& chart, bool logarithmic, const std::vector<int>& shown) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Chart::Curve& c : chart.curves) {
    if (!shown.empty() && std::find(shown.begin(), shown.end(), c.number) == shown.end()) continue;
    for (const Chart::Point& p : c.points) {
      for (const double v : {p.value.low, p.value.high}) {
        if (std::isfinite(v) && (!logarithmic || v > 0)) low = std::min(low, v), high = std::max(high, v);
      }
    }
  }
  if (low > high) low = 0, high = 1;
  const double margin = logarithmic ? 0 : 0.05 * (high - low);
  return {low - margin, high + margin, logarithmic};
}

std::string text_of(double v, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, v);
  return text;
}

std::string curve_colour(int number) {
  // Okabe and Ito's colours, which the colour-blind can tell apart; light enough for dark paper too.
  constexpr const char* all[] = {"#e69f00", "#56b4e9", "#009e73", "#d55e00",
                                 "#cc79a7", "#0072b2", "#9c9c00", "#7f7f7f"};
  return all[std::size_t(number - 1) % std::size(all)];
}

}
