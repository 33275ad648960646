#include "ui/plot.h"

#include <algorithm>
#include <cmath>

#include "main/files.h"
#include "ui/panes.h"

namespace sudar::ui {

namespace {

constexpr ImU32 paper_colour = IM_COL32(20, 22, 27, 255), grid_colour = IM_COL32(52, 56, 64, 255),
                text_colour = IM_COL32(170, 176, 186, 255);

ImU32 colour_of(const Chart::Curve& c) {
  const unsigned rgb = unsigned(std::stoul(curve_colour(c.number).substr(1), nullptr, 16));
  return IM_COL32(rgb >> 16, rgb >> 8 & 255, rgb & 255, c.ghost ? 100 : 255);
}

// A curve's band between its extremes, which is a line where nothing was merged.
void draw_curve(ImDrawList& draw, const Chart::Curve& c, const Axis& x, const Axis& y) {
  std::vector<ImVec2> line;
  const auto end = [&] {
    if (line.size() > 1) draw.AddPolyline(line.data(), int(line.size()), colour_of(c), 0, 1.5f);
    line.clear();
  };
  for (const Chart::Point& p : c.points) {
    for (const double v : {p.value.low, p.value.high}) {
      if (!y.shows(v)) {
        end();
        continue;
      }
      line.push_back({float(x(p.time)), float(y(v))});
      if (p.value.low == p.value.high) break;
    }
  }
  end();
}

void draw_grid(ImDrawList& draw, const Axis& x, const Axis& y, float left, float top, float right, float bottom) {
  for (const double t : x.ticks(6)) {
    const auto at = float(x(t));
    draw.AddLine({at, top}, {at, bottom}, grid_colour);
    draw.AddText({at - 8, bottom + 2}, text_colour, text_of(t, 5).c_str());
  }
  for (const double t : y.ticks(4)) {
    const auto at = float(y(t));
    draw.AddLine({left, at}, {right, at}, grid_colour);
    const std::string text = text_of(t, 4);
    draw.AddText({left - 4 - ImGui::CalcTextSize(text.c_str()).x, at - 7}, text_colour, text.c_str());
  }
}

// The number at or before that time; NaN: there is none.
double at_time(const Chart::Curve& c, double time) {
  const auto behind = std::upper_bound(c.points.begin(), c.points.end(), time,
                                       [](double t, const Chart::Point& p) { return t < p.time; });
  return behind == c.points.begin() ? NAN : std::prev(behind)->value.high;
}

}

void Plot::add_menu(const Moment& m) {
  if (ImGui::SmallButton("+ Curve")) ImGui::OpenPopup("add a curve");
  controls_.places.note("add curve");
  if (!ImGui::BeginPopup("add a curve")) return;
  Simulation& s = controls_.simulation();
  const auto list = [&](const char* title, const char* group, const Quantity& of) {
    if (ImGui::BeginMenu(title)) {
      for (std::size_t i = 0; i < quantities(of.of).size(); ++i) {
        const QuantityKind& k = quantities(of.of)[i];
        Quantity q = of;
        q.which = int(i);
        if (ImGui::MenuItem(k.name, k.unit)) s.post([q](History& h) { h.watch(q); });
        controls_.places.note(std::string("curve: ") + group + "." + k.name);
      }
      ImGui::EndMenu();
    }
    controls_.places.note(std::string("curves of ") + group);
  };
  list("The whole", "world", {});
  if (m.selected) {
    list(("Selected: " +
          (m.selected->name.empty() ? "body " + std::to_string(m.selected->body.index) : m.selected->name))
             .c_str(),
         "body", {.of = Quantity::Of::body, .a = m.selected->body});
  } else {
    ImGui::TextDisabled("select a body for its curves");
  }
  for (const Related& r : m.related) list(r.title.c_str(), r.title.c_str(), r.quantity);
  ImGui::EndPopup();
}

void Plot::exports(const Moment& m) {
  const auto button = [&](const char* text, auto made) {
    if (ImGui::SmallButton(text) && m.chart) {
      Simulation& s = controls_.simulation();
      s.post([&s, made, extension = std::string(text)](History& h) {
        // All of it, as fine as it is kept.
        const Chart all = chart_of(h, {.points = 1 << 20});
        const std::string file = app::unused_name(h.run().session().entry().name, extension == "CSV" ? ".csv" : ".svg");
        const std::string data = made(all, app::provenance(h.run().playback()));
        app::write_file(file, std::as_bytes(std::span(data)));
        s.say("Curves: " + file);
      });
    }
    controls_.places.note(std::string("export ") + text);
    ImGui::SameLine();
  };
  button("CSV", [](const Chart& c, const auto& from) { return as_csv(c, from); });
  button("SVG", [log = logarithmic_](const Chart& c, const auto& from) { return as_svg(c, log, from); });
  ImGui::NewLine();
}

void Plot::choices(const Moment& m, float width) {
  ImGui::BeginChild("choices", {width, 0});
  add_menu(m);
  ImGui::SameLine();
  exports(m);
  ImGui::Checkbox("log", &logarithmic_);
  controls_.places.note("log");
  ImGui::SameLine();
  const auto name_of = [&](int number) -> const char* {
    for (const Chart::Curve& c : m.chart->curves) {
      if (c.number == number) return c.name.c_str();
    }
    return "time";
  };
  ImGui::SetNextItemWidth(-1);
  const bool open = ImGui::BeginCombo("##against", (std::string("over ") + name_of(against_)).c_str());
  controls_.places.note("over");
  if (open) {
    if (ImGui::Selectable("time", against_ == 0)) against_ = 0;
    controls_.places.note("over time");
    for (const Chart::Curve& c : m.chart->curves) {
      if (c.ghost) continue;
      if (ImGui::Selectable(c.name.c_str(), against_ == c.number)) against_ = c.number;
      controls_.places.note("over " + c.name);
    }
    ImGui::EndCombo();
  }
  for (const Chart::Curve& c : m.chart->curves) {
    if (c.ghost) continue;
    ImGui::PushID(c.number);
    bool on = shown(c);
    ImGui::PushStyleColor(ImGuiCol_CheckMark, colour_of(c));
    if (ImGui::Checkbox("##on", &on)) on ? void(hidden_.erase(c.number)) : void(hidden_[c.number] = true);
    ImGui::PopStyleColor();
    controls_.places.note("show " + c.name);
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of(c)), "%s", c.name.c_str());
    const double v = at_time(c, m.time);
    if (std::isfinite(v)) ImGui::SameLine(), ImGui::Text("%.4g %s", v, c.unit.c_str());
    ImGui::SameLine();
    if (ImGui::SmallButton("×")) controls_.simulation().post([n = c.number](History& h) { h.unwatch(n); });
    controls_.places.note("remove " + c.name);
    ImGui::PopID();
  }
  ImGui::EndChild();
}

void Plot::mouse(const Chart& chart, const Axis& time, const Paper& p) {
  ImGui::SetCursorScreenPos({p.x, p.y});
  ImGui::InvisibleButton("paper", {p.width, p.height});
  controls_.places.note("plot");
  const ImGuiIO& io = ImGui::GetIO();
  const double pointed = time.value(double(io.MousePos.x));
  const double low = time.low(), high = time.high();
  if (ImGui::IsItemActivated()) pulled_ = false;
  if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0, 3)) {
    const double way = -double(io.MouseDelta.x) / double(p.width) * (high - low);
    from_ = low + way, to_ = high + way, pulled_ = true;
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0) {
    const double factor = std::pow(0.8, double(io.MouseWheel));
    from_ = pointed - (pointed - low) * factor, to_ = pointed + (high - pointed) * factor;
    if (from_ <= chart.first && to_ >= chart.last) from_ = to_ = 0;
  }
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) from_ = to_ = 0;
  if (ImGui::IsItemDeactivated() && !pulled_) {
    const Chart::Point* nearest = nullptr;
    for (const Chart::Curve& c : chart.curves) {
      for (const Chart::Point& i : c.points) {
        if (!c.ghost && (!nearest || std::abs(i.time - pointed) < std::abs(nearest->time - pointed))) nearest = &i;
      }
    }
    if (nearest) controls_.simulation().go(nearest->frame);
  }
  if (!ImGui::IsItemHovered()) return;
  ImGui::GetWindowDrawList()->AddLine({io.MousePos.x, p.y}, {io.MousePos.x, p.y + p.height}, text_colour);
  ImGui::BeginTooltip();
  ImGui::Text("t = %.5g s", pointed);
  for (const Chart::Curve& c : chart.curves) {
    const double v = at_time(c, pointed);
    if (shown(c) && std::isfinite(v)) {
      ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour_of(c) | IM_COL32(0, 0, 0, 255)), "%s%s  %.6g %s",
                         c.name.c_str(), c.ghost ? " (ghost)" : "", v, c.unit.c_str());
    }
  }
  ImGui::EndTooltip();
}

// Each unit has a scale of its own; the ticks are those of the first.
void Plot::time_curves(const Moment& m, const Paper& p) {
  const Chart& chart = *m.chart;
  Axis time = to_ > from_ ? Axis(from_, to_) : Axis(chart.first, std::max(chart.last, chart.first + 1e-3));
  time.place(double(p.x), double(p.x + p.width));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  std::map<std::string, std::vector<int>> by_unit;
  std::vector<std::string> units;
  for (const Chart::Curve& c : chart.curves) {
    if (!shown(c)) continue;
    if (by_unit[c.unit].empty()) units.push_back(c.unit);
    by_unit[c.unit].push_back(c.number);
  }
  bool first = true;
  for (const std::string& unit : units) {
    Axis y = axis_of(chart, logarithmic_, by_unit[unit]);
    y.place(double(p.y + p.height), double(p.y));
    if (std::exchange(first, false)) {
      draw_grid(draw, time, y, p.x, p.y, p.x + p.width, p.y + p.height);
      draw.AddText({p.x + 4, p.y + 2}, text_colour, unit.c_str());
    }
    draw.PushClipRect({p.x, p.y}, {p.x + p.width, p.y + p.height}, true);
    for (const Chart::Curve& c : chart.curves) {
      if (shown(c) && c.unit == unit) draw_curve(draw, c, time, y);
    }
    draw.PopClipRect();
  }
  const auto now = float(time(m.time));
  if (now >= p.x && now <= p.x + p.width) draw.AddLine({now, p.y}, {now, p.y + p.height}, IM_COL32_WHITE);
  mouse(chart, time, p);
}

// One quantity against another, where both were measured at the same step.
void Plot::phase(const Moment& m, const Paper& p) {
  const Chart& chart = *m.chart;
  const auto same = [&](const Chart::Curve& c) { return c.number == against_ && !c.ghost; };
  const auto base = std::find_if(chart.curves.begin(), chart.curves.end(), same);
  if (base == chart.curves.end()) return void(against_ = 0);
  std::vector<int> others;
  for (const Chart::Curve& c : chart.curves) {
    if (shown(c) && c.number != against_) others.push_back(c.number);
  }
  if (others.empty()) others.push_back(against_);
  Axis x = axis_of(chart, false, {against_}), y = axis_of(chart, logarithmic_, others);
  x.place(double(p.x), double(p.x + p.width)), y.place(double(p.y + p.height), double(p.y));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw_grid(draw, x, y, p.x, p.y, p.x + p.width, p.y + p.height);
  const std::string title = title_of(*base);
  draw.AddText({p.x + p.width - ImGui::CalcTextSize(title.c_str()).x - 4, p.y + p.height - 17}, text_colour,
               title.c_str());
  draw.PushClipRect({p.x, p.y}, {p.x + p.width, p.y + p.height}, true);
  for (const Chart::Curve& c : chart.curves) {
    if (c.ghost || std::find(others.begin(), others.end(), c.number) == others.end()) continue;
    std::vector<ImVec2> line;
    auto b = base->points.begin();
    for (const Chart::Point& i : c.points) {
      while (b != base->points.end() && b->frame < i.frame) ++b;
      if (b == base->points.end()) break;
      if (b->frame != i.frame || !x.shows(b->value.low) || !y.shows(i.value.low)) continue;
      line.push_back({float(x((b->value.low + b->value.high) / 2)), float(y((i.value.low + i.value.high) / 2))});
      if (b->time <= m.time && !(std::next(b) != base->points.end() && std::next(b)->time <= m.time)) {
        draw.AddCircleFilled(line.back(), 3.5f, IM_COL32_WHITE);
      }
    }
    if (line.size() > 1) draw.AddPolyline(line.data(), int(line.size()), colour_of(c), 0, 1.5f);
  }
  draw.PopClipRect();
  ImGui::SetCursorScreenPos({p.x, p.y});
  ImGui::InvisibleButton("paper", {p.width, p.height});
  controls_.places.note("plot");
}

void Plot::request() {
  const ChartRequest now{.from = from_, .to = to_, .points = std::max(100, width_)};
  if (now == asked_) return;
  controls_.simulation().chart(asked_ = now);
}

void Plot::draw(float x, float y, float width, float height) {
  begin_panel("plot", x, y, width, height, ImGuiWindowFlags_NoScrollbar);
  const Moment* m = controls_.moment();
  if (m && m->chart) {
    constexpr float left = 56, below = 18, choices_width = 270;
    choices(*m, choices_width);
    const Paper p{x + choices_width + 20 + left, y + 8, width - choices_width - 36 - left, height - 16 - below};
    if (p.width > 40 && p.height > 20) {
      width_ = int(p.width);
      ImGui::GetWindowDrawList()->AddRectFilled({p.x, p.y}, {p.x + p.width, p.y + p.height}, paper_colour);
      against_ != 0 ? phase(*m, p) : time_curves(*m, p);
    }
  }
  ImGui::End();
  request();
}

}
