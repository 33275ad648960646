#include <sudar/difference.h>

#include <cstring>

#include "world/state_list.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

using Part = StateList::Part;

// Of two parts of the same name whose bytes differ.
Difference difference(const Part& a, const Part& b) {
  const std::size_t size = a.type.size;
  std::size_t i = 0;
  const bool alike = a.bytes.size() == b.bytes.size() && size == b.type.size;
  while (alike && std::memcmp(&a.bytes[i * size], &b.bytes[i * size], size) == 0) ++i;
  const Leaves of_a = a.leaves(i), of_b = b.leaves(i);
  std::size_t leaf = 0;  // the first that differs; where all read the same (two kinds of NaN), the first
  while (leaf < of_a.size() && leaf < of_b.size() && of_a[leaf].text == of_b[leaf].text) ++leaf;
  if (leaf >= of_a.size() || leaf >= of_b.size()) leaf = 0;
  return {part_path(a.path, of_a[leaf].path.c_str()),
          {},
          a.array ? std::int64_t(i) : a.index,
          of_a[leaf].text,
          of_b[leaf].text};
}

// Whose field it is.
void name_body(Difference& d, const Bodies& bodies) {
  if (d.index < 0) return;
  const auto row = std::uint32_t(d.index);
  const auto take = [&](const std::string& prefix, const Slots& rows, auto body_of) {
    if (d.field.rfind(prefix, 0) != 0 || !rows.used(row)) return;
    d.field.erase(0, prefix.size());
    d.body = bodies.slots.handle<BodyTag>(body_of(row));
  };
  take("bodies.", bodies.slots, [](std::uint32_t i) { return i; });
  take("shapes.", bodies.shapes.slots, [&](std::uint32_t s) { return bodies.shapes.body[s]; });
}

}

std::optional<Difference> difference(const World& a, const World& b) {
  const StateList of_a(a.impl()), of_b(b.impl());
  const std::size_t count = std::min(of_a.parts().size(), of_b.parts().size());
  for (std::size_t i = 0; i < count; ++i) {
    const Part &part = of_a.parts()[i], &other = of_b.parts()[i];
    if (part.bytes == other.bytes) continue;
    Difference d = difference(part, other);
    name_body(d, a.impl().bodies);
    return d;
  }
  return {};
}

}
