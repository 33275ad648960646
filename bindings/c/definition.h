// Fields of definitions by path, through describe(): "material.restitution", "shapes[1].at".
#pragma once

#include <charconv>
#include <span>
#include <string_view>

#include "described.h"

namespace sudar::c {

// What a field can be set to. Each says whether it is something for a field of that type, and sets it.
struct NumbersValue {
  static constexpr const char* what = "numbers";
  std::span<const double> numbers;
  template <class F>
  bool set(F& field) const {
    if constexpr (std::is_arithmetic_v<F>) {
      if (numbers.size() != 1) return false;
      if constexpr (std::is_integral_v<F>) {  // bool, too
        const double x = numbers[0];
        if (!(x >= double(std::numeric_limits<F>::min()) && x <= double(std::numeric_limits<F>::max())) ||
            double(F(x)) != x)
          return false;
      }
      field = F(numbers[0]);
      return true;
    } else if constexpr (std::is_same_v<F, Vec3> || std::is_same_v<F, Pos>) {
      if (numbers.size() != 3) return false;
      for (int i = 0; i < 3; ++i)
        field[i] = static_cast<std::remove_reference_t<decltype(field[i])>>(numbers[std::size_t(i)]);
      return true;
    } else if constexpr (std::is_same_v<F, Quat>) {
      if (numbers.size() != 4) return false;
      field = {Real(numbers[0]), Real(numbers[1]), Real(numbers[2]), Real(numbers[3])};
      return true;
    } else if constexpr (std::is_same_v<F, Mat3>) {
      if (numbers.size() != 9) return false;
      for (int i = 0; i < 9; ++i) field[i % 3][i / 3] = Real(numbers[std::size_t(i)]);
      return true;
    } else {
      return false;
    }
  }
};
struct TextValue {
  static constexpr const char* what = "a text";
  std::string_view text;
  template <class F>
  bool set(F& field) const {
    if constexpr (std::is_same_v<F, std::string>) return field = text, true;
    if constexpr (std::is_enum_v<F>) {
      for (int i = 0; names(F{})[i]; ++i) {
        if (text == names(F{})[i]) return field = F(i), true;
      }
    }
    return false;
  }
};
template <class V>
struct PlainValue {  // a Shape, a Body
  static constexpr const char* what = std::is_same_v<V, Shape> ? "a shape" : "a body";
  V value;
  template <class F>
  bool set(F& field) const {
    if constexpr (std::is_same_v<F, V>)
      return field = value, true;
    else
      return false;
  }
};

template <class Value>
class PathSetter {
 public:
  PathSetter(std::string_view path, std::string_view whole, const Value& value) : whole_(whole), value_(value) {
    const std::size_t end = path.find_first_of(".[");
    name_ = path.substr(0, end);
    rest_ = end == path.npos ? "" : path.substr(end);
  }
  template <class F, class Rule>
  void operator()(const char* name, F& field, const Rule&) {
    if (name_ == name) found_ = true, set(field, rest_);
  }

  template <class T>
  static void apply(T& definition, std::string_view path, std::string_view whole, const Value& value) {
    PathSetter setter(path, whole, value);
    describe(setter, definition);
    if (!setter.found_) throw Error(std::string(whole), "is no field");
  }

 private:
  static constexpr std::size_t most = 1u << 20;

  template <class F>
  void set(F& field, std::string_view rest) {
    if constexpr (OptionalOf<F>::value) {
      if (!field) field.emplace();
      set(*field, rest);
    } else if constexpr (VectorOf<F>::value) {
      std::size_t index = most;
      const char* const end = rest.data() + rest.size();
      if (rest.starts_with('[')) {
        const auto [stop, error] = std::from_chars(rest.data() + 1, end, index);
        if (error == std::errc{} && stop != end && *stop == ']')
          rest = {stop + 1, end};
        else
          index = most;
      }
      if (index >= most) throw Error(std::string(whole_), "expected " + std::string(name_) + "[number]");
      if (field.size() <= index) field.resize(index + 1);
      set(field[index], rest);
    } else if constexpr (Described<F>) {
      if (!rest.starts_with('.')) throw Error(std::string(whole_), "has fields of its own: set those");
      apply(field, rest.substr(1), whole_, value_);
    } else {
      if (!rest.empty()) throw Error(std::string(whole_), "is no field");
      if (!value_.set(field)) throw Error(std::string(whole_), std::string("cannot be set to these: ") + Value::what);
    }
  }

  std::string_view name_, rest_, whole_;
  const Value& value_;
  bool found_ = false;
};

}
