// Bytes out and in: what snapshots, recordings and their hashes are made of. Little-endian, no padding: plain values are
// written as they lie in memory, so only types without padding may come in (a static_assert cannot see floats' padding;
// arrays of structs assert their size where they are declared). Anything with a describe() is written field by field.
#pragma once

#include "base/hash.h"
#include "base/leaves.h"

#include <cstring>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

// What is written, value by value. Subclasses keep the bytes, or hash them, or look at what they mean: one write() of a
// type serves them all.
class Writer {
 public:
  Writer() = default;
  Writer(const Writer&) = delete;
  virtual ~Writer() = default;

  // Values of a type without padding, side by side.
  template <class T>
    requires std::is_trivially_copyable_v<T>
  void plain(const T* values, std::size_t count) { put(values, count, plain_type<T>()); }
  template <Number T>
  void value(T x) { plain(&x, 1); }
  virtual void text(const std::string& s) {
    value(std::uint64_t(s.size()));
    plain(s.data(), s.size());
  }
  template <class T>
  void array(const std::vector<T>& a) {
    put_count(a.size());
    plain(a.data(), a.size());
  }
  // As array() does, what lies somewhere else: `row` of a number is one of them.
  template <class T, class F>
  void rows(std::size_t count, F row) {
    put_count(count);
    if (by_example() && count == 0) plain(std::array<T, 1>{}.data(), 1);
    for (std::size_t i = 0; i < count; ++i) {
      enter_element("", i);
      plain(&row(i), 1);
      leave();
    }
  }
  // A part of a whole. The name is for those who look at the meaning.
  template <class T>
  void named(const char* name, const T& x) {
    enter(name);
    write(*this, x);
    leave();
  }
  // Parts of one kind whose number is known: one for each slot.
  template <class T>
  void each(const char* name, const std::vector<T>& parts) {
    if (by_example() && parts.empty()) named(name, T{});
    for (std::size_t i = 0; i < parts.size(); ++i) {
      enter_element(name, i);
      write(*this, parts[i]);
      leave();
    }
  }
  // The visitor of describe().
  template <class T, class Rule>
  void operator()(const char* name, const T& x, const Rule&) { named(name, x); }
  // Whether all that could be there is to be written, an example of each kind.
  virtual bool by_example() const { return false; }

 protected:
  virtual void put(const void* values, std::size_t count, const PlainType&) = 0;
  virtual void put_count(std::uint64_t count) { value(count); }
  virtual void enter(const char*) {}
  virtual void enter_element(const char* name, std::size_t) { enter(name); }
  virtual void leave() {}
};

// Keeps what is written.
class ByteWriter : public Writer {
 public:
  std::vector<std::byte> take() { return std::move(bytes_); }
  // Ends with a hash of all that was written, for unseal().
  std::vector<std::byte> take_sealed() {
    value(hash_bytes(bytes_.data(), bytes_.size()));
    return take();
  }
  const std::vector<std::byte>& bytes() const { return bytes_; }
  void raw(std::span<const std::byte> bytes) { put(bytes.data(), bytes.size(), plain_type<std::uint8_t>()); }

 private:
  void put(const void* values, std::size_t count, const PlainType& type) override {
    const std::size_t end = bytes_.size(), size = count * type.size;
    bytes_.resize(end + size);
    if (size > 0) std::memcpy(bytes_.data() + end, values, size);
  }
  std::vector<std::byte> bytes_;
};

// Hashes what is written, in place.
class HashWriter : public Writer {
 public:
  std::uint64_t hash() const { return hash_; }

 private:
  void put(const void* values, std::size_t count, const PlainType& type) override {
    hash_ = hash_bytes(values, count * type.size, hash_);
  }
  std::uint64_t hash_ = 0;
};

// Hashes how things are written: names, types and their order, but no values.
class LayoutWriter : public Writer {
 public:
  std::uint64_t layout() const { return hash_; }
  bool by_example() const override { return true; }

 private:
  void put(const void*, std::size_t, const PlainType& type) override {
    const std::vector<std::max_align_t> zero(type.size / sizeof(std::max_align_t) + 1);
    Leaves leaves;
    type.leaves(zero.data(), leaves);
    add(std::to_string(type.size));
    for (const Leaf& leaf : leaves) add(leaf.path + " " + leaf.type);
  }
  void enter(const char* name) override { add(std::string("{") + name); }
  void leave() override { add("}"); }
  void add(const std::string& word) { hash_ = hash_bytes(word.data(), word.size(), hash_); }
  std::uint64_t hash_ = 0;
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
template <class T>
  requires std::is_trivially_copyable_v<T>
void write(Writer& w, const std::vector<T>& x) { w.array(x); }
template <class T>
  requires std::is_trivially_copyable_v<T>
void read(Reader& r, std::vector<T>& x) { r.array(x); }
template <class Tag>
void write(Writer& w, const Handle<Tag>& h) {
  w.named("index", h.index), w.named("generation", std::uint32_t(h.generation));
}
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

// Parts of any kind and number.
template <class T>
  requires(!std::is_trivially_copyable_v<T>)
void write(Writer& w, const std::vector<T>& parts) {
  w.named("count", std::uint64_t(parts.size()));
  w.each("", parts);
}
template <class T>
  requires(!std::is_trivially_copyable_v<T>)
void read(Reader& r, std::vector<T>& parts) {
  parts.clear();
  for (std::size_t n = r.count(1); n > 0; --n) read(r, parts.emplace_back());
}

// An optional value: whether it is there, then itself.
template <class T>
void write(Writer& w, const std::optional<T>& x) {
  w.value(std::uint8_t(x ? 1 : 0));
  if (x || w.by_example()) write(w, x ? *x : T{});
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
  if (w.by_example()) return (write(w, T{}), ...);
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
