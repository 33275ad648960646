// Something told for each frame from a first one on, in bounded memory: where there are too many, neighbours are
// merged, so that one entry stands for 2, 4, 8 … frames. T::merge(T) says how: an extreme or a mark is never lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sudar::history {

template <class T>
class Thinned {
 public:
  explicit Thinned(std::int64_t first = 0, std::size_t most = 1 << 15) : first_(first), most_(most) {}

  void append(const T& value) {
    if (count_ % stride_ == 0 && entries_.size() >= most_) halve();
    if (count_ % stride_ == 0) {
      entries_.push_back(value);
    } else {
      entries_.back().merge(value);
    }
    ++count_;
  }

  void merge_last(const T& value) { entries_.back().merge(value); }

  // Without the frames before `first`, as far as entries are that fine.
  void forget_before(std::int64_t first) {
    const std::int64_t whole = first <= first_ ? 0 : (first - first_) / stride_;
    const auto n = whole < std::int64_t(entries_.size()) ? whole : std::int64_t(entries_.size());
    entries_.erase(entries_.begin(), entries_.begin() + n);
    first_ += n * stride_, count_ = count_ > n * stride_ ? count_ - n * stride_ : 0;
  }

  std::int64_t first() const { return first_; }
  std::int64_t end() const { return first_ + count_; }  // one behind the last frame
  std::int64_t stride() const { return stride_; }       // frames an entry
  std::size_t size() const { return entries_.size(); }
  const T& operator[](std::size_t i) const { return entries_[i]; }
  std::int64_t frame(std::size_t i) const { return first_ + std::int64_t(i) * stride_; }  // the entry's first
  std::size_t bytes() const { return entries_.capacity() * sizeof(T); }

 private:
  void halve() {
    for (std::size_t i = 0; 2 * i < entries_.size(); ++i) {
      T both = entries_[2 * i];
      if (2 * i + 1 < entries_.size()) both.merge(entries_[2 * i + 1]);
      entries_[i] = both;
    }
    entries_.resize((entries_.size() + 1) / 2);
    stride_ *= 2;
  }

  std::int64_t first_, count_ = 0, stride_ = 1;
  std::size_t most_;
  std::vector<T> entries_;
};

}
