// The branches of a History and their keyframes.
#include <algorithm>

#include "history/course.h"

namespace sudar::history {

namespace {

constexpr std::size_t most_branches = 12;
constexpr std::int64_t far = 1024, near = 64;  // frames from the present: what lies nearer is worth more

}

History::Course& History::course(int number) { return const_cast<Course&>(std::as_const(*this).course(number)); }

const History::Course& History::course(int number) const {
  const auto c = std::find_if(courses_.begin(), courses_.end(), [&](const auto& i) { return i->number == number; });
  if (c == courses_.end()) throw Error("branch", "there is none of that number");
  return **c;
}

const History::Course* History::parent(const Course& c) const { return c.parent < 0 ? nullptr : &course(c.parent); }

const History::Course& History::owner(const Course& c, std::int64_t frame) const {
  return c.parent < 0 || frame > c.from ? c : owner(course(c.parent), frame);
}

const std::vector<Deed>& History::deeds_at(const Course& c, std::int64_t frame) const {
  static const std::vector<Deed> none;
  if (frame < c.from && c.parent >= 0) return deeds_at(course(c.parent), frame);
  const auto d = c.deeds.find(frame);
  return d == c.deeds.end() ? none : d->second;
}

History::Course& History::add_course(std::string name, int parent, std::int64_t from) {
  auto c = std::make_unique<Course>();
  c->number = ++numbers_;
  c->name = name.empty() ? std::to_string(c->number) : std::move(name);
  c->parent = parent;
  c->from = c->end = from;
  c->time = Thinned<Span>(c->first_sample());
  c->marks = Thinned<Mark>(from);
  c->marks.append({});
  for (const Watched& w : watched_) {
    const Quantity q = parent < 0 ? rebound(w.quantity, run_->world()) : course(parent).curves.at(w.number).quantity;
    c->curves[w.number] = {q, Thinned<Span>(c->first_sample()), Thinned<Span>(c->first_sample())};
  }
  courses_.push_back(std::move(c));
  return *courses_.back();
}

// With the run as it is.
void History::begin_alone(std::string name) {
  Course& c = add_course(std::move(name), -1, run_->world().steps());
  c.settings = run_->settings();
  c.measure(run_->world(), c.from);
  branch_ = c.number, frame_ = c.from, done_ = 0;
  keep(c, frame_, *run_);
  limit_branches();
}

// The present leaves the future that is known from here.
void History::leave() {
  const Course& old = course(branch_);
  const std::vector<Deed>& deeds = deeds_at(old, frame_);
  const std::vector<Deed> so_far(deeds.begin(), deeds.begin() + std::ptrdiff_t(done_));
  Course& c = add_course("", owner(old, frame_).number, frame_);
  if (!so_far.empty()) c.deeds[frame_] = so_far;
  branch_ = c.number;
  limit_branches();
}

void History::limit_branches() {
  const auto shown = [](const auto& c) { return !c->removed; };
  while (std::size_t(std::count_if(courses_.begin(), courses_.end(), shown)) > most_branches) {
    const auto oldest = std::find_if(courses_.begin(), courses_.end(),
                                     [&](const auto& c) { return shown(c) && c->number != branch_ && !c->named; });
    if (oldest == courses_.end()) return;
    remove((*oldest)->number);
  }
}

std::vector<History::Branch> History::branches() const {
  std::vector<Branch> all;
  for (const auto& c : courses_) {
    if (!c->removed) all.push_back(*c);
  }
  return all;
}

const History::Branch& History::branch() const { return course(branch_); }

const History::Course& History::root_of(const Course& c) const { return c.parent < 0 ? c : root_of(course(c.parent)); }

std::int64_t History::begin() const { return root_of(course(branch_)).from; }

void History::rename(int number, std::string name) {
  Course& c = course(number);
  c.name = std::move(name);
  c.named = true;
}

void History::remove(int number) {
  if (number == branch_) throw Error("branch", "is the one shown: switch to another one first");
  course(number).removed = true;
  drop_removed();
}

// What was removed stays as far as others have come from it.
void History::drop_removed() {
  for (bool changed = true; changed;) {
    changed = false;
    for (const auto& c : courses_) {
      if (!c->removed) continue;
      std::int64_t last = -1;
      for (const auto& child : courses_) {
        if (child->parent == c->number) last = std::max(last, child->from);
      }
      if (last >= 0) {
        c->cut_behind(last);
        continue;
      }
      std::erase_if(courses_, [number = c->number](const auto& i) { return i->number == number; });
      changed = true;
      break;
    }
  }
  for (auto* made : {&ghost_, &filler_}) {
    const bool there = *made && std::any_of(courses_.begin(), courses_.end(),
                                            [&](const auto& c) { return c->number == (*made)->at.branch; });
    if (!there) made->reset();
  }
}

void History::keep(const Course& c, std::int64_t frame, const Run& run) {
  Course& owns = course(owner(c, frame).number);
  if (owns.keyframes.contains(frame)) return;
  owns.keyframes[frame] = run.save();
  kept_ += bytes_of(owns.keyframes[frame]);
  if (kept_ > most_.bytes) thin();
}

// An eighth goes: those whose loss makes the shortest gaps, far ones before near ones; never two neighbours at once,
// and never the first one of all.
void History::thin() {
  struct Candidate {
    double worth;
    Course* course;
    std::int64_t frame;
    std::size_t place;  // in the order of all
  };
  std::vector<Candidate> all;
  std::vector<const Course*> chain;
  for (const Course* c = &course(branch_); c; c = parent(*c)) chain.push_back(c);
  kept_ = 0;
  for (const auto& c : courses_) {
    const bool here = std::find(chain.begin(), chain.end(), c.get()) != chain.end();
    for (auto k = c->keyframes.begin(); k != c->keyframes.end(); ++k) {
      kept_ += bytes_of(k->second);
      const auto next = std::next(k);
      if (k == c->keyframes.begin() && c->parent < 0) continue;
      const std::int64_t before = k == c->keyframes.begin() ? c->from : std::prev(k)->first;
      const std::int64_t after = next == c->keyframes.end() ? c->end : next->first;
      const std::int64_t away = here ? std::min(far, std::abs(k->first - frame_)) : far;
      all.push_back({double(after - before + 1) / (1 + double(away) / near), c.get(), k->first, all.size()});
    }
  }
  std::vector<bool> gone(all.size() + 1, false);
  std::sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) {
    return a.worth != b.worth ? a.worth < b.worth : a.place < b.place;
  });
  for (const Candidate& k : all) {
    if (kept_ <= most_.bytes - most_.bytes / 8) return;
    if (gone[k.place + 1] || (k.place > 0 && gone[k.place - 1])) continue;
    gone[k.place] = true;
    const auto at = k.course->keyframes.find(k.frame);
    kept_ -= bytes_of(at->second);
    k.course->keyframes.erase(at);
  }
}

std::pair<std::int64_t, const Run::Saved*> History::keyframe(const Course& c, std::int64_t frame) const {
  const Course& owns = owner(c, frame);
  const auto behind = owns.keyframes.upper_bound(frame);
  if (behind != owns.keyframes.begin()) return {std::prev(behind)->first, &std::prev(behind)->second};
  return keyframe(course(owns.parent), std::min(frame, owns.from));  // a branch that begins by itself has one
}

// What a hand did for hours: the first quarter goes, and the branches that go out from there.
void History::forget_beginning() {
  std::size_t deeds = 0;
  for (const auto& c : courses_) deeds += c->count_deeds();
  if (deeds <= most_.deeds) return;
  const auto first = keyframe(course(branch_), begin() + (frame_ - begin()) / 4).first;  // clang 14 captures no binding
  if (first <= begin()) return;
  Course& c = course(owner(course(branch_), first).number);
  c.whole = false;
  c.parent = -1, c.from = first;
  c.deeds.erase(c.deeds.begin(), c.deeds.lower_bound(first));
  c.keyframes.erase(c.keyframes.begin(), c.keyframes.lower_bound(first));
  c.time.forget_before(first), c.marks.forget_before(first);
  for (auto& [number, curve] : c.curves) curve.past.forget_before(first), curve.live.forget_before(first);
  const auto reaches = [&](const Course& i) {  // does its past begin there?
    const Course* at = &i;
    while (at->number != c.number && at->parent >= 0 && at->from >= first) at = parent(*at);
    return at->number == c.number;
  };
  std::vector<int> lost;
  for (const auto& i : courses_) {
    if (!reaches(*i)) lost.push_back(i->number);
  }
  std::erase_if(courses_, [&](const auto& i) { return std::find(lost.begin(), lost.end(), i->number) != lost.end(); });
  drop_removed();
}

std::size_t History::bytes() const {
  std::size_t sum = 0;
  for (const auto& c : courses_) sum += c->bytes();
  return sum;
}

}
