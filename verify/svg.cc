#include "verify/svg.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace sudar::verify {

namespace {

constexpr double width = 640, height = 320, left = 84, right = 16, top = 14, bottom = 44;

template <class... A>
std::string format(const char* pattern, A... a) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, a...);
  return text;
}

// One axis: what it shows, and where that is on the paper.
struct Axis {
  double low = 0, high = 1, from = 0, to = 1;
  double operator()(double v) const { return from + (v - low) / (high - low) * (to - from); }
  double step() const {  // 1, 2 or 5 times a power of ten, about six a side
    const double raw = (high - low) / 6, power = std::pow(10, std::floor(std::log10(raw))), digit = raw / power;
    return power * (digit > 5 ? 10 : digit > 2 ? 5 : digit > 1 ? 2 : 1);
  }
};

Axis axis_for(std::initializer_list<const Points*> all, bool second, double from, double to) {
  Axis a{1e300, -1e300, from, to};
  for (const Points* points : all) {
    for (const auto& [x, y] : *points) {
      const double v = second ? y : x;
      if (std::isfinite(v)) a.low = std::min(a.low, v), a.high = std::max(a.high, v);
    }
  }
  if (a.low > a.high) a.low = 0, a.high = 1;
  double margin = (a.high - a.low) * (second ? 0.06 : 0);
  if (a.high - a.low < 1e-12 * std::max(1e-300, std::fabs(a.high))) margin = std::max(std::fabs(a.high) * 0.1, 1e-9);
  a.low -= margin, a.high += margin;
  return a;
}

std::string line(const Axis& x, const Axis& y, const Points& points) {
  std::string path;
  for (const auto& [px, py] : points) {
    if (std::isfinite(px) && std::isfinite(py)) path += format("%s%.1f %.1f", path.empty() ? "M" : "L", x(px), y(py));
  }
  return path.empty() ? "" : "<path class=\"theory\" d=\"" + path + "\"/>\n";
}

std::string dots(const Axis& x, const Axis& y, const Points& points, double radius) {
  std::string all;
  const std::size_t every = std::max<std::size_t>(1, points.size() / 100);
  for (std::size_t i = 0; i < points.size(); i += every) {
    const auto& [px, py] = points[i];
    if (std::isfinite(px) && std::isfinite(py))
      all += format("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"%.1f\"/>", x(px), y(py), radius);
  }
  return "<g class=\"dots\">" + all + "</g>\n";
}

std::string frame(const Axis& x, const Axis& y, const std::string& x_name, const std::string& y_name,
                  bool logarithmic) {
  std::string s;
  const auto ticks = [&](const Axis& a, bool vertical) {
    const double step = logarithmic ? std::max(1.0, std::ceil((a.high - a.low) / 6)) : a.step();
    for (double v = std::ceil(a.low / step - 1e-9) * step; v <= a.high + 1e-9 * step; v += step) {
      const double shown = std::fabs(v) < 1e-9 * step ? 0 : v, at = a(v);
      const std::string label = logarithmic ? format("1e%d", int(std::lround(shown))) : format("%.5g", shown);
      if (vertical) {
        s += format("<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", left, width - right, at,
                    at);
        s += format("<text text-anchor=\"end\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", left - 7, at + 4, label.c_str());
      } else {
        s += format("<line class=\"grid\" x1=\"%.1f\" x2=\"%.1f\" y1=\"%.1f\" y2=\"%.1f\"/>", at, at, top,
                    height - bottom);
        s += format("<text text-anchor=\"middle\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", at, height - bottom + 17,
                    label.c_str());
      }
    }
  };
  ticks(x, false), ticks(y, true);
  s += format("<rect class=\"axis\" x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\"/>\n", left, top,
              width - left - right, height - top - bottom);
  s += format("<text class=\"name\" text-anchor=\"middle\" x=\"%.0f\" y=\"%.0f\">", (left + width - right) / 2,
              height - 8) +
       escaped(x_name) + "</text>";
  s += format("<text class=\"name\" text-anchor=\"middle\" transform=\"translate(13 %.0f) rotate(-90)\">",
              (top + height - bottom) / 2) +
       escaped(y_name) + "</text>\n";
  return s;
}

std::string picture(const std::string& inside) {
  return format("<svg class=\"curve\" viewBox=\"0 0 %.0f %.0f\" role=\"img\">\n", width, height) + inside + "</svg>\n";
}

}

std::string draw_curves(const Plot& p) {
  const Axis x = axis_for({&p.theory, &p.simulation}, false, left, width - right);
  const Axis y = axis_for({&p.theory, &p.simulation}, true, height - bottom, top);
  return picture(frame(x, y, p.x, p.y, false) + line(x, y, p.theory) +
                 dots(x, y, p.simulation, p.simulation.size() > 60 ? 2 : 2.6));
}

std::string draw_convergence(const Points& sweep, double order) {
  Points measured, demanded;
  for (const auto& [h, error] : sweep) {
    if (h > 0 && error > 0) measured.emplace_back(std::log10(h), std::log10(error));
  }
  if (measured.size() < 2) return "";
  const auto& [h0, e0] = measured.back();
  for (const auto& [h, e] : measured) demanded.emplace_back(h, e0 + order * (h - h0));
  Axis x = axis_for({&measured, &demanded}, false, left + 20, width - right - 20);
  Axis y = axis_for({&measured, &demanded}, true, height - bottom, top);
  return picture(frame(x, y, "length of a sub-step [s]", "error", true) + line(x, y, demanded) +
                 dots(x, y, measured, 4));
}

std::string escaped(std::string_view text) {
  std::string s;
  for (const char c : text) {
    switch (c) {
      case '&':
        s += "&amp;";
        break;
      case '<':
        s += "&lt;";
        break;
      case '>':
        s += "&gt;";
        break;
      case '"':
        s += "&quot;";
        break;
      default:
        s += c;
    }
  }
  return s;
}

}
