// Generational slots: hands out indices into parallel arrays, takes them back, and knows a dead handle from a live one.
// Freed slots are used again last in, first out; that order decides later indices, so all of it is state. The world that the handles are of is none: nothing that is
// computed depends on it.
#pragma once

#include "base/archive.h"

namespace sudar::inline SUDAR_PRECISION {

class Slots {
 public:
  std::uint32_t take() {
    ++live_;
    if (!free_.empty()) {
      const std::uint32_t i = free_.back();
      free_.pop_back();
      ++generation_[i];
      return i;
    }
    generation_.push_back(1);
    return std::uint32_t(generation_.size() - 1);
  }
  void give_back(std::uint32_t i) {
    --live_;
    if (++generation_[i] < last) free_.push_back(i);  // else its generations are used up, and it stays empty
  }
  // A generation is odd while its slot is in use.
  bool used(std::uint32_t i) const { return i < generation_.size() && (generation_[i] & 1) != 0; }
  template <class Tag>
  bool alive(Handle<Tag> h) const {
    return h.world == world_ && h.index < generation_.size() && generation_[h.index] == h.generation && used(h.index);
  }
  void belong_to(std::uint32_t world) { world_ = world; }
  std::uint32_t generation(std::uint32_t i) const { return generation_[i]; }
  std::uint32_t size() const { return std::uint32_t(generation_.size()); }  // slots ever made: the length of the arrays
  std::uint32_t live() const { return live_; }
  template <class Tag>
  Handle<Tag> handle(std::uint32_t i) const { 
    Handle<Tag> h{i};
    h.generation = generation_[i] & last, h.world = world_ & (Handle<Tag>::worlds - 1);
    return h;
  }

  friend void write(Writer& w, const Slots& s) { w.named("live", s.live_), w.named("generation", s.generation_), w.named("free", s.free_); }
  friend void read(Reader& r, Slots& s) {
    s.live_ = r.value<std::uint32_t>(), r.array(s.generation_), r.array(s.free_);
    std::vector<bool> seen(s.generation_.size());
    for (const std::uint32_t i : s.free_) {
      if (i >= seen.size() || seen[i] || s.used(i) || s.generation_[i] >= last) throw Error("data", "frees a slot that is not free");
      seen[i] = true;
    }
    std::uint32_t used = 0, worn = 0;
    for (std::uint32_t i = 0; i < s.size(); ++i) {
      used += s.used(i) ? 1 : 0;
      worn += !s.used(i) && s.generation_[i] > last ? 1 : 0;
    }
    if (used != s.live_ || used + worn + s.free_.size() != s.size()) throw Error("data", "loses a slot");
  }

 private:
  static constexpr std::uint32_t last = Body::last_generation;
  std::vector<std::uint32_t> generation_, free_;
  std::uint32_t live_ = 0;
  std::uint32_t world_ = 0;
};

}
