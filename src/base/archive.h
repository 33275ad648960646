// Bytes out and in: what snapshots, recordings and their hashes are made of. Little-endian, no padding: plain values are
// written as they lie in memory, so only types without padding may come in (a static_assert cannot see floats' padding;
// arrays of structs assert their size where they are declared). Anything with a describe() is written field by field.
#pragma once

#include "base/hash.h"

#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class Writer {
 public:
  void raw(const void* data, std::size_t size) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + size);
    if (size > 0) std::memcpy(bytes_.data() + end, data, size);
  }
  template <Number T>
  void value(T x) { raw(&x, sizeof x); }
  void text(const std::string& s) {
    value(std::uint64_t(s.size()));
    raw(s.data(), s.size());
  }
  // An array of plain data without padding.
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void array(const std::vector<T>& a) {
    value(std::uint64_t(a.size()));
    raw(a.data(), a.size() * sizeof(T));
  }
  // The visitor of describe().
  template <class T, class Rule>
  void operator()(const char*, const T& x, const Rule&) { write(*this, x); }

  std::vector<std::byte> take() { return std::move(bytes_); }
  // Ends with a hash of all that was written, for unseal().
  std::vector<std::byte> take_sealed() {
    value(hash_bytes(bytes_.data(), bytes_.size()));
    return take();
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

// Throws Error("data", …) where the bytes end too soon; a size that cannot be right is refused before memory is taken.
class Reader {
 public:
  // `world`: which one the handles in it are of.
  explicit Reader(std::span<const std::byte> bytes, std::size_t from = 0, std::uint32_t world = 0)
      : bytes_(bytes), position_(from), world_(world) {
    if (from > bytes.size()) fail_short();
  }
  void raw(void* data, std::size_t size) {
    if (size > left()) fail_short();
    if (size > 0) std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  }
  template <Number T>
  T value() {
    if constexpr (std::is_same_v<T, bool>) {  // a byte that is neither 0 nor 1 is no bool
      return value<std::uint8_t>() != 0;
    } else {
      T x;
      raw(&x, sizeof x);
      return x;
    }
  }
  std::size_t count(std::size_t element_size) {
    const auto n = value<std::uint64_t>();
    if (n > left() / element_size) throw Error("data", "names more elements than it holds");
    return std::size_t(n);
  }
  std::string text() {
    std::string s(count(1), '\0');
    raw(s.data(), s.size());
    return s;
  }
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void array(std::vector<T>& a) {
    a.resize(count(sizeof(T)));
    raw(a.data(), a.size() * sizeof(T));
  }
  template <class T, class Rule>
  void operator()(const char*, T& x, const Rule&) { read(*this, x); }

  std::size_t left() const { return bytes_.size() - position_; }
  std::size_t position() const { return position_; }
  std::uint32_t world() const { return world_; }

 private:
  [[noreturn]] static void fail_short() { throw Error("data", "ends in the middle of a value"); }
  std::span<const std::byte> bytes_;
  std::size_t position_;
  std::uint32_t world_;
};

// What take_sealed() wrote, without its hash; throws Error("data", …) where it is cut short or damaged.
inline std::span<const std::byte> unseal(std::span<const std::byte> bytes) {
  std::uint64_t hash = 0;
  if (bytes.size() >= sizeof hash) {
    const auto content = bytes.first(bytes.size() - sizeof hash);
    std::memcpy(&hash, bytes.data() + content.size(), sizeof hash);
    if (hash == hash_bytes(content.data(), content.size())) return content;
  }
  throw Error("data", "is cut short or damaged");
}

// write() and read() for everything that a description may hold.
template <Number T>
void write(Writer& w, const T& x) { w.value(x); }
template <Number T>
void read(Reader& r, T& x) { x = r.value<T>(); }
inline void write(Writer& w, const std::string& s) { w.text(s); }
inline void read(Reader& r, std::string& s) { s = r.text(); }
inline void write(Writer& w, const std::vector<std::byte>& x) { w.array(x); }
inline void read(Reader& r, std::vector<std::byte>& x) { r.array(x); }
template <class Tag>
void write(Writer& w, const Handle<Tag>& h) { w.value(h.index), w.value(std::uint32_t(h.generation)); }
template <class Tag>
void read(Reader& r, Handle<Tag>& h) {
  h.index = r.value<std::uint32_t>();
  const auto generation = r.value<std::uint32_t>();
  if (generation > Handle<Tag>::last_generation) throw Error("data", "names a generation that does not exist");
  h.generation = generation & Handle<Tag>::last_generation;
  h.world = (h.null() ? 0 : r.world()) & (Handle<Tag>::worlds - 1);
}
template <class T>
  requires requires(Writer& w, const T& x) { describe(w, x); }
void write(Writer& w, const T& x) { describe(w, x); }
template <class T>
  requires requires(Reader& r, T& x) { describe(r, x); }
void read(Reader& r, T& x) { describe(r, x); }

// An optional value: whether it is there, then itself.
template <class T>
void write(Writer& w, const std::optional<T>& x) {
  w.value(std::uint8_t(x ? 1 : 0));
  if (x) write(w, *x);
}
template <class T>
void read(Reader& r, std::optional<T>& x) {
  x.reset();
  if (r.value<std::uint8_t>() != 0) read(r, x.emplace());
}

// A variant: which alternative, then its fields.
template <class... T>
void write(Writer& w, const std::variant<T...>& v) {
  w.value(std::uint32_t(v.index()));
  std::visit([&](const auto& x) { write(w, x); }, v);
}
template <class... T>
void read(Reader& r, std::variant<T...>& v) {
  const auto which = r.value<std::uint32_t>();
  if (which >= sizeof...(T)) throw Error("data", "names an alternative that does not exist");
  std::uint32_t i = 0;
  const auto take = [&]<class X>(X x) {
    if (i++ != which) return;
    read(r, x);
    v = std::move(x);
  };
  (take(T{}), ...);
}

}
