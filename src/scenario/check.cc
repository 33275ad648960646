#include <sudar/scenario.h>

#include <algorithm>

#include "base/archive.h"

namespace sudar::inline SUDAR_PRECISION {

void Check::visit(double time, double dt, bool active) { time_ = time, dt_ = dt, active_ = active; }

void Check::below(std::string_view name, double value, double limit, std::string_view unit) {
  note(name, "<", value, limit, 0, unit, true);
}
void Check::above(std::string_view name, double value, double limit, std::string_view unit) {
  note(name, ">", value, limit, 0, unit, true);
}
void Check::near(std::string_view name, double value, double expected, double tolerance, std::string_view unit) {
  note(name, "=", value, expected, tolerance, unit, true);
}
void Check::that(std::string_view name, bool holds) { note(name, "holds", holds ? 1 : 0, 1, 0, "", true); }

// A step's times may be off by rounding, so a time counts as reached half a step before it.
Check::When Check::at(double time) { return {*this, time_ >= time - dt_ / 2 && time_ < time + dt_ / 2}; }
Check::When Check::from(double time) { return {*this, time_ >= time - dt_ / 2}; }
Check::When Check::between(double from, double to) { return {*this, time_ >= from - dt_ / 2 && time_ < to + dt_ / 2}; }

void Check::note(std::string_view name, const char* op, double value, double limit, double tolerance,
                 std::string_view unit, bool active) {
  auto at = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == name; });
  if (at == entries_.end()) {
    entries_.push_back({std::string(name), op, std::string(unit), 0, limit, tolerance, 0, {}});
    at = entries_.end() - 1;
  }
  if (!active || !active_) return;
  // How bad a value is: a verdict is good where this is below zero. NaN is as bad as can be.
  const auto badness = [&](double v) {
    double bad = 0;
    if (at->op == "<") bad = v - limit;
    else if (at->op == ">") bad = limit - v;
    else if (at->op == "=") bad = std::abs(v - limit) - tolerance;
    else bad = 0.5 - v;
    return bad == bad ? bad : infinite;
  };
  const double bad = badness(value);
  if (at->pass && bad <= badness(at->value)) return;
  const bool good = at->op == "=" ? bad <= 0 : bad < 0;
  at->value = value, at->limit = limit, at->tolerance = tolerance, at->at = time_;
  at->pass = at->pass.value_or(true) && good;
}

bool Check::passed() const {
  const auto failed = [](const Entry& e) { return e.pass && !*e.pass; };
  const auto judged = [](const Entry& e) { return e.pass.has_value(); };
  return std::none_of(entries_.begin(), entries_.end(), failed) &&
         std::any_of(entries_.begin(), entries_.end(), judged);
}

Bytes Check::save() const {
  ByteWriter w;
  w.value(std::uint64_t(entries_.size()));
  for (const Entry& e : entries_) {
    w.text(e.name), w.text(e.op), w.text(e.unit);
    w.value(e.value), w.value(e.limit), w.value(e.tolerance), w.value(e.at);
    w.value(e.pass.has_value()), w.value(e.pass.value_or(false));
  }
  return w.take();
}

void Check::load(const Bytes& bytes) {
  Reader r(bytes);
  entries_.resize(r.count(1));
  for (Entry& e : entries_) {
    e.name = r.text(), e.op = r.text(), e.unit = r.text();
    e.value = r.value<double>(), e.limit = r.value<double>(), e.tolerance = r.value<double>(), e.at = r.value<double>();
    const bool judged = r.value<bool>(), pass = r.value<bool>();
    e.pass = judged ? std::optional(pass) : std::nullopt;
  }
}

}
