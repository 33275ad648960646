// How every file of the engine begins: what it is, the version of its format, its precision, who wrote it, and the
// layout of what follows as a number that changes by itself with every field gained, lost or renamed (LayoutWriter).
// What has another layout is refused: its bytes would be taken for other fields.
#pragma once

#include <sudar/version.h>

#include "base/archive.h"

namespace sudar::inline SUDAR_PRECISION {

// Of all formats together. To be raised with what LayoutWriter cannot see: the same fields with another meaning.
inline constexpr std::uint32_t format_version = 2;

inline void write_header(Writer& w, std::uint64_t magic, std::uint64_t layout) {
  w.value(magic), w.value(format_version), w.value(std::uint32_t(sizeof(Real)));
  w.text(SUDAR_VERSION);
  w.value(layout);
}

inline bool has_magic(std::span<const std::byte> file, std::uint64_t magic) {
  return file.size() >= sizeof magic && std::memcmp(file.data(), &magic, sizeof magic) == 0;
}

// Throws Error: `what` it should have been, or what it is of.
inline void read_header(Reader& r, std::uint64_t magic, std::uint64_t layout, const char* what) {
  if (r.left() < sizeof magic || r.value<std::uint64_t>() != magic) throw Error("data", std::string("is not ") + what);
  if (const auto version = r.value<std::uint32_t>(); version != format_version) {
    throw Error("version", "is " + std::to_string(version) + ", this program reads " + std::to_string(format_version));
  }
  if (const auto precision = r.value<std::uint32_t>(); precision != sizeof(Real)) {
    throw Error("precision",
                std::string("is ") + (precision == 4 ? "float" : "double") + ", this program has the other one");
  }
  const std::string writer = r.text();
  if (const auto other = r.value<std::uint64_t>(); other != layout) {
    throw Error("layout", "is " + value_text(other) + ", written by sudar " + writer +
                              "; this program, sudar " SUDAR_VERSION ", reads " + value_text(layout));
  }
}

}
