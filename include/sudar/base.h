// What every other header needs: the precision, handles and errors.
#pragma once

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

// A typed generational handle: null by default, and dead as soon as what it names is removed.
template <class Tag>
struct Handle {
  std::uint32_t index = 0xffffffffu;
  std::uint32_t generation = 0;
  constexpr bool null() const { return index == 0xffffffffu; }
  constexpr bool operator==(const Handle&) const = default;
  constexpr auto operator<=>(const Handle&) const = default;
};

using Body = Handle<struct BodyTag>;
using Joint = Handle<struct JointTag>;
using ForceId = Handle<struct ForceTag>;

}
