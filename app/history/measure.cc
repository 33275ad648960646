// What is measured of a History's steps, and what happened in them.
#include <algorithm>
#include <cmath>

#include "history/course.h"

namespace sudar::history {

void Span::merge(const Span& s) {
  if (std::isnan(low)) return void(*this = s);
  if (std::isnan(s.low)) return;
  low = std::min(low, s.low), high = std::max(high, s.high);
}

int History::watch(const Quantity& q) {
  const World& w = run_->world();
  for (const Watched& known : watched_) {
    if (known.quantity == q) return known.number;
  }
  const int number = ++watches_;
  watched_.push_back({number, q, name(w, q), unit(w, q)});
  for (const auto& c : courses_) {
    c->curves[number] = {q, Thinned<Span>(c->first_sample()), Thinned<Span>(std::max(c->first_sample(), c->end + 1))};
  }
  return number;
}

void History::unwatch(int number) {
  std::erase_if(watched_, [&](const Watched& w) { return w.number == number; });
  for (const auto& c : courses_) c->curves.erase(number);
}

// Makes the steps again beside the run, branch after branch.
bool History::fill(Clock::time_point deadline) {
  const auto lacks = [](const Course::Curve& k) { return k.past.end() < k.live.first(); };
  for (const auto& c : courses_) {
    for (;;) {
      std::int64_t next = c->end + 1;
      for (const auto& [number, curve] : c->curves) {
        if (lacks(curve)) next = std::min(next, curve.past.end());
      }
      if (next > c->end) break;
      if (!filler_) filler_ = std::make_unique<Made>();
      // Before the deeds there, as it was when the others were measured.
      if (!approach(filler_->run, filler_->at, {c->number, next, 0}, deadline, false)) return true;
      for (auto& [number, curve] : c->curves) {
        if (!lacks(curve) || curve.past.end() != next) continue;
        const double v = value(filler_->run->world(), curve.quantity);
        curve.past.append({v, v});
      }
      if (Clock::now() > deadline) return true;
    }
  }
  filler_.reset();
  return false;
}

std::vector<History::Sample> History::curve(int branch, int number) const {
  std::vector<const Course*> chain;
  for (const Course* c = &course(branch); c; c = parent(*c)) chain.insert(chain.begin(), c);
  std::vector<Sample> all;
  for (std::size_t n = 0; n < chain.size(); ++n) {
    const Course& c = *chain[n];
    const auto k = c.curves.find(number);
    if (k == c.curves.end()) continue;
    const std::int64_t last = n + 1 < chain.size() ? chain[n + 1]->from : c.end;
    const auto time_of = [&](std::int64_t frame) {
      const auto i = std::size_t((frame - c.time.first()) / c.time.stride());
      const Span& t = c.time[std::min(i, c.time.size() - 1)];
      const std::int64_t span = std::max<std::int64_t>(1, c.time.stride() - 1);
      return t.low + (t.high - t.low) * double(frame - c.time.frame(i)) / double(span);
    };
    for (const Thinned<Span>* part : {&k->second.past, &k->second.live}) {
      for (std::size_t i = 0; i < part->size() && part->frame(i) <= last; ++i) {
        all.push_back({part->frame(i), time_of(part->frame(i)), (*part)[i]});
      }
    }
  }
  return all;
}

std::vector<History::MarkAt> History::marks() const {
  std::vector<const Course*> chain;
  for (const Course* c = &course(branch_); c; c = parent(*c)) chain.insert(chain.begin(), c);
  std::vector<MarkAt> all;
  for (std::size_t n = 0; n < chain.size(); ++n) {
    const Thinned<Mark>& marks = chain[n]->marks;
    const std::int64_t last = n + 1 < chain.size() ? chain[n + 1]->from : chain[n]->end;
    for (std::size_t i = 0; i < marks.size() && marks.frame(i) <= last; ++i) {
      if (marks[i].bits != 0) all.push_back({marks.frame(i), marks[i]});
    }
  }
  return all;
}

}
