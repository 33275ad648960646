// What every other header needs: the precision, handles and errors.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

// Everything lives in an inline namespace named after the precision, so that a program that mixes
// a float build with a double build fails at link and not at run time.
#ifdef SUDAR_DOUBLE
#define SUDAR_PRECISION f64
#else
#define SUDAR_PRECISION f32
#endif

namespace sudar::inline SUDAR_PRECISION {

#ifdef SUDAR_DOUBLE
using Real = double;
#else
using Real = float;
#endif

// Bad user data: a definition, a file, a command. `field` names what was wrong ("shape", "joint.axis"),
// what() says the same with the reason in one sentence. Whatever threw has changed nothing.
class Error : public std::runtime_error {
 public:
  Error(std::string field_name, const std::string& reason)
      : std::runtime_error(field_name.empty() ? reason : field_name + ": " + reason), field(std::move(field_name)) {}
  std::string field;
};

// A typed generational handle: null by default, and dead as soon as what it names is removed. It is of one world, and
// good in those that were loaded from what that one saved; every other world refuses it by name.
template <class Tag>
struct Handle {
  static constexpr std::uint32_t last_generation = (1u << 20) - 1, worlds = 1u << 12;
  std::uint32_t index = 0xffffffffu;
  std::uint32_t generation : 20 = 0;
  std::uint32_t world : 12 = 0;  // its number modulo `worlds`: in no hash, and no result depends on it
  constexpr bool null() const { return index == 0xffffffffu; }
  constexpr bool operator==(const Handle&) const = default;
  constexpr auto operator<=>(const Handle& h) const { return order() <=> h.order(); }  // g++ 12 makes none of bit-fields

 private:
  constexpr std::uint64_t order() const {
    return std::uint64_t(index) << 32 | std::uint64_t(generation) << 12 | std::uint64_t(world);
  }
};

using Body = Handle<struct BodyTag>;
using Joint = Handle<struct JointTag>;
using ForceId = Handle<struct ForceTag>;
using ShapeId = Handle<struct ShapeTag>;  // one of a body's shapes

}
