#include "history/chart.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "history/axis.h"
#include "verify/svg.h"

namespace sudar::history {

namespace {

// At most about `points` of what lies in the window and one beside it on each side, so that lines reach its edges.
std::vector<Chart::Point> thinned(const std::vector<History::Sample>& samples, const ChartRequest& r) {
  auto first = samples.begin(), last = samples.end();
  if (r.to > r.from) {
    const auto before = [](const History::Sample& s, double t) { return s.time < t; };
    first = std::lower_bound(samples.begin(), samples.end(), r.from, before);
    last = std::lower_bound(first, samples.end(), r.to, before);
    if (first != samples.begin()) --first;
    if (last != samples.end()) ++last;
  }
  const auto group = std::max<std::ptrdiff_t>(1, (last - first) / std::max(1, r.points));
  std::vector<Chart::Point> points;
  for (auto s = first; s != last; ++s) {
    if ((s - first) % group == 0) {
      points.push_back({s->frame, s->time, s->value});
    } else {
      points.back().value.merge(s->value);
    }
  }
  return points;
}

}

Chart chart_of(const History& h, const ChartRequest& r) {
  Chart chart;
  const auto add = [&](int branch, bool ghost) {
    for (const History::Watched& w : h.watched()) {
      const std::vector<History::Sample> samples = h.curve(branch, w.number);
      if (!samples.empty()) {
        chart.first = std::min(chart.curves.empty() ? samples.front().time : chart.first, samples.front().time);
        chart.last = std::max(chart.last, samples.back().time);
      }
      chart.curves.push_back({w.number, w.name, w.unit, ghost, thinned(samples, r)});
    }
  };
  add(h.branch().number, false);
  if (r.ghost >= 0) add(r.ghost, true);
  chart.marks.assign(mark_parts, 0);
  const std::int64_t begin = h.begin(), frames = std::max<std::int64_t>(1, h.end() - begin + 1);
  for (const History::MarkAt& m : h.marks()) {
    const std::int64_t part = (m.frame - begin) * mark_parts / frames;
    if (part >= 0 && part < mark_parts) chart.marks[std::size_t(part)] |= m.mark.bits;
  }
  return chart;
}

std::string title_of(const Chart::Curve& c) {
  std::string title = c.name;
  if (!c.unit.empty()) title.append(" [").append(c.unit).append("]");
  if (c.ghost) title.append(" (ghost)");
  return title;
}

std::string as_csv(const Chart& chart, const std::vector<std::pair<std::string, std::string>>& provenance) {
  std::ostringstream out;
  out.precision(9);
  for (const auto& [key, text] : provenance) out << "# " << key << ": " << text << '\n';
  out << "time [s]";
  for (const Chart::Curve& c : chart.curves) out << ",\"" << title_of(c) << '"';
  out << '\n';
  // Each curve has its own times where it was thinned or begins later: a row for every time of any of them.
  std::vector<double> times;
  for (const Chart::Curve& c : chart.curves) {
    for (const Chart::Point& p : c.points) times.push_back(p.time);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  std::vector<std::size_t> next(chart.curves.size(), 0);
  for (const double t : times) {
    out << t;
    for (std::size_t i = 0; i < chart.curves.size(); ++i) {
      const std::vector<Chart::Point>& points = chart.curves[i].points;
      out << ',';
      if (next[i] < points.size() && points[next[i]].time == t) {
        const Span v = points[next[i]++].value;
        if (std::isfinite(v.low)) out << (v.low + v.high) / 2;
      }
    }
    out << '\n';
  }
  return out.str();
}

std::string as_svg(const Chart& chart, bool logarithmic,
                   const std::vector<std::pair<std::string, std::string>>& provenance) {
  constexpr double width = 960, height = 480, left = 80, right = 20, top = 20, bottom = 48;
  Axis x(chart.first, chart.last), y = axis_of(chart, logarithmic);
  x.place(left, width - right), y.place(height - bottom, top);
  std::ostringstream s;
  s.precision(6);
  s << "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 960 480\" font-family=\"sans-serif\" "
       "font-size=\"13\">\n"
       "<desc>";
  for (const auto& [key, text] : provenance) s << verify::escaped(key + ": " + text) << '\n';
  s << "</desc>\n<rect width=\"960\" height=\"480\" fill=\"white\"/>\n";
  for (const double t : x.ticks(8)) {
    s << "<path stroke=\"#ddd\" d=\"M" << x(t) << ' ' << top << 'V' << height - bottom
      << "\"/><text text-anchor=\"middle\" x=\"" << x(t) << "\" y=\"450\">" << t << "</text>\n";
  }
  for (const double t : y.ticks(6)) {
    s << "<path stroke=\"#ddd\" d=\"M" << left << ' ' << y(t) << 'H' << width - right
      << "\"/><text text-anchor=\"end\" x=\"74\" y=\"" << y(t) + 4 << "\">" << t << "</text>\n";
  }
  s << "<text text-anchor=\"middle\" x=\"510\" y=\"472\">time [s]</text>\n";
  double legend = top + 16;
  for (const Chart::Curve& c : chart.curves) {
    s << "<path fill=\"none\" stroke-width=\"1.5\" stroke=\"" << curve_colour(c.number) << "\" stroke-opacity=\""
      << (c.ghost ? 0.4 : 1) << "\" d=\"";
    const char* pen = "M";
    for (const Chart::Point& p : c.points) {
      for (const double v : {p.value.low, p.value.high}) {
        if (y.shows(v)) {
          s << pen << x(p.time) << ' ' << y(v);
          pen = "L";
        } else {
          pen = "M";
        }
        if (p.value.low == p.value.high) break;
      }
    }
    s << "\"/>\n";
    if (c.ghost) continue;
    s << "<text x=\"96\" y=\"" << legend << "\" fill=\"" << curve_colour(c.number) << "\">"
      << verify::escaped(title_of(c)) << "</text>\n";
    legend += 17;
  }
  s << "</svg>\n";
  return s.str();
}

}
