// Refuses bad definitions, naming the field: a visitor of describe() (sudar/definitions.h).
#pragma once

#include <sudar/definitions.h>

#include "base/archive.h"
#include "base/text.h"

namespace sudar::inline SUDAR_PRECISION {

// How many values an enum with names() has.
template <class E>
int count_of(E e) {
  int n = 0;
  while (names(e)[n] != nullptr) ++n;
  return n;
}

class Validator {
 public:
  explicit Validator(std::string path) : path_(std::move(path)) {}

  template <class Rule>
  void operator()(const char*, const std::string&, const Rule&) {}
  template <class Tag, class Rule>
  void operator()(const char*, const Handle<Tag>&, const Rule&) {}  // whether it is alive is the world's to say
  template <class T>
    requires std::is_arithmetic_v<T>
  void operator()(const char* name, const T& x, const Range& range) { number(name, double(x), range); }
  template <class T>
    requires std::is_arithmetic_v<T>
  void operator()(const char* name, const T& x, const OrInfinite&) {
    if (!(double(x) >= 0)) fail(name, "is " + text(double(x)) + ", must not be negative (infinite is allowed)");
  }
  template <class T>
    requires std::is_arithmetic_v<T>
  void operator()(const char* name, const T& x, const NotNan&) {
    if (std::isnan(double(x))) fail(name, "is not a number");
  }
  template <class E, class Rule>
    requires std::is_enum_v<E>
  void operator()(const char* name, const E& e, const Rule&) {
    if (int(e) >= count_of(e)) fail(name, "is not one of its values");
  }
  template <class V>
    requires(std::is_same_v<V, Vec3> || std::is_same_v<V, Pos>)
  void operator()(const char* name, const V& v, const Range& range) {
    if (!is_finite(v)) fail(name, "is not finite");
    const double size = length(Vec3d{double(v.x), double(v.y), double(v.z)});
    if (size > range.high) fail(name, "has length " + text(size) + ", must be at most " + text(range.high));
  }
  void operator()(const char* name, const Vec3& v, const UnitLength&) {
    if (!is_finite(v) || abs(length(v) - 1) > Real(1e-3))
      fail(name, "must have length 1, has " + text(double(length(v))));
  }
  void operator()(const char* name, const Quat& q, const UnitLength&) {
    if (!is_finite(q) || abs(sqrt(length_squared(q)) - 1) > Real(1e-3)) fail(name, "must be a unit quaternion");
  }
  void operator()(const char* name, const Mat3& m, const Range&) {
    if (!is_finite(m.c0) || !is_finite(m.c1) || !is_finite(m.c2)) fail(name, "is not finite");
    const Vec3 skew{m.c1.z - m.c2.y, m.c2.x - m.c0.z, m.c0.y - m.c1.x};
    if (length(skew) > Real(1e-4) * abs(trace(m))) fail(name, "is not symmetric");
  }
  template <class T, class Rule>
  void operator()(const char* name, const std::optional<T>& x, const Rule& rule) {
    if (x) (*this)(name, *x, rule);
  }
  void operator()(const char* name, const Shape& shape, const Range&) {
    if (!shape) fail(name, "is missing");
  }
  void operator()(const char*, const Shape&, const MayBeMissing&) {}
  template <class T, class Rule>
  void operator()(const char* name, const std::vector<T>& parts, const Rule& rule) {
    for (std::size_t k = 0; k < parts.size(); ++k) {
      (*this)(std::string(name).append("[").append(std::to_string(k)).append("]").c_str(), parts[k], rule);
    }
  }
  template <class T, class Rule>
    requires requires(Validator& v, const T& x) { describe(v, x); }
  void operator()(const char* name, const T& x, const Rule&) {
    Validator inner(path(name));
    describe(inner, x);
  }

  [[noreturn]] void fail(const char* name, const std::string& reason) const { throw Error(path(name), reason); }

 private:
  std::string path(const char* name) const { return path_.empty() ? name : path_ + "." + name; }
  void number(const char* name, double x, const Range& range) const {
    if (std::isnan(x) || std::isinf(x)) fail(name, "is not finite");
    if (x < range.low || x > range.high || (range.above && x == range.low)) {
      fail(name, "is " + text(x) + ", must be " + allowed(range, x));
    }
  }
  static std::string allowed(const Range& r, double x) {
    const std::string low = text(r.low), high = text(r.high);
    if (r.high < greatest) return "within " + low + " and " + high;
    if (x > r.high) return "at most " + high;
    return (r.above ? "above " : "at least ") + low;
  }
  std::string path_;
};

template <class T>
void validate(const char* what, const T& definition) {
  Validator v(what);
  describe(v, definition);
}

}
