// How described aggregates lie in memory, as a number. A program and its plugins must agree on it, and sizes do not
// tell: a new bool often finds room in the padding of an old one.
#pragma once

#include <sudar/definitions.h>

namespace sudar::inline SUDAR_PRECISION {

// Visits the fields, and their fields: names, places and sizes.
class Layout {
 public:
  template <class T>
  static std::uint64_t of() {
    const T object{};
    Layout layout(&object);
    layout.add(sizeof(T));
    describe(layout, object);
    return layout.hash_;
  }
  // Of all alternatives.
  template <class... T>
  static std::uint64_t of(const std::variant<T...>&) {
    Layout all(nullptr);
    (all.add(of<T>()), ...);
    return all.hash_;
  }

  template <class T, class Rule>
  void operator()(const char* name, const T& field, const Rule&) {
    for (; *name != '\0'; ++name) add(std::uint64_t(*name));
    add(std::uint64_t(reinterpret_cast<const char*>(&field) - static_cast<const char*>(object_)));
    add(sizeof(T));
    if constexpr (requires { describe(*this, field); }) describe(*this, field);
  }

 private:
  explicit Layout(const void* object) : object_(object) {}
  void add(std::uint64_t word) { hash_ = (hash_ ^ word) * 0x100000001b3; }  // after FNV-1a (Fowler, Noll, Vo)
  const void* object_;
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}
