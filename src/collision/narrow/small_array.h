// Working memory of one collision: on the stack up to N elements, on the heap beyond. Elements start uninitialised,
// because clearing the stack would cost more than the collision of two boxes.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

template <class T, std::size_t N>
class SmallArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);

 public:
  explicit SmallArray(std::size_t capacity) {
    if (capacity > N) heap_.reset(new std::byte[capacity * sizeof(T)]);
    data_ = reinterpret_cast<T*>(heap_ ? heap_.get() : stack_);
  }
  SmallArray(const SmallArray&) = delete;
  SmallArray& operator=(const SmallArray&) = delete;

  void push(const T& value) { new (data_ + size_++) T(value); }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  T& operator[](std::size_t i) { return data_[i]; }
  const T& operator[](std::size_t i) const { return data_[i]; }
  T* begin() { return data_; }
  T* end() { return data_ + size_; }
  const T* begin() const { return data_; }
  const T* end() const { return data_ + size_; }
  std::span<T> all() { return {data_, size_}; }
  std::span<const T> all() const { return {data_, size_}; }

 private:
  T* data_;
  std::size_t size_ = 0;
  std::unique_ptr<std::byte[]> heap_;
  alignas(T) std::byte stack_[N * sizeof(T)];
};

}
