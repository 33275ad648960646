// What can be measured in a world, by name: the curves that are drawn and exported. A quantity of something that is not
// there, or not any more, is NaN.
#pragma once

#include <sudar/world.h>

#include <string>

namespace sudar::history {

struct Quantity {
  enum class Of { world, body, joint, contact, sensor };
  Of of = Of::world;
  int which = 0;  // number in quantities(of)
  Body a{}, b{};  // of a body, or of a contact: between these two
  Joint joint{};
  SensorId sensor{};
  bool operator==(const Quantity&) const = default;
};

struct QuantityKind {
  const char *name, *unit;
};
// What can be told of the whole, of a body, …
std::span<const QuantityKind> quantities(Quantity::Of);

double value(const World&, const Quantity&);
std::string name(const World&, const Quantity&);  // "ball.x"; with a number where it has no name
std::string unit(const World&, const Quantity&);

// The same of another world, made by the same scenario: handles are of one world.
Quantity rebound(const Quantity&, const World&);

// Of the whole, by name: "total energy".
Quantity of_world(std::string_view name);

}
