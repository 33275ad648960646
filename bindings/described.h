// What every binding asks about a type of a definition (sudar/definitions.h).
#pragma once

#include <sudar/definitions.h>

#include <cxxabi.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <typeinfo>

namespace sudar {

template <class T>
struct OptionalOf : std::false_type {};
template <class T>
struct OptionalOf<std::optional<T>> : std::true_type {
  using Type = T;
};
template <class T>
struct VectorOf : std::false_type {};
template <class T>
struct VectorOf<std::vector<T>> : std::true_type {
  using Type = T;
};

struct AnyVisitor {
  template <class F, class Rule>
  void operator()(const char*, F&, const Rule&) {}
};
template <class T>
concept Described = requires(AnyVisitor v, T& x) {
  describe(v, x);
};

// "BodyDef".
template <class T>
std::string name_of_type() {
  const std::unique_ptr<char, decltype(&std::free)> name(
      abi::__cxa_demangle(typeid(T).name(), nullptr, nullptr, nullptr), &std::free);
  const std::string whole = name.get();
  return whole.substr(whole.rfind(':') + 1);
}

}
