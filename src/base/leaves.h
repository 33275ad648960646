// What plain data consists of, down to numbers: a name, a type and the value in words for each. For telling people what
// differs (compare.h) and programs that a layout is another one (archive.h); nothing here is fast.
#pragma once

#include <sudar/base.h>

#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>
#include <vector>

namespace sudar::inline SUDAR_PRECISION {

struct Leaf {
  std::string path, type, text;  // "points[2].at", "f4 f4 f4", "[0, 0.5, 0]"
};
using Leaves = std::vector<Leaf>;

template <class T>
concept Number = std::is_arithmetic_v<T> || std::is_enum_v<T>;

// "f4", "u1": floating, signed or unsigned, and its bytes. An enumeration is "u1 dynamic kinematic fixed".
template <Number T>
std::string type_name() {
  if constexpr (std::is_enum_v<T>) {
    std::string type = type_name<std::underlying_type_t<T>>();
    if constexpr (requires { names(T{}); }) {
      for (const char* const* name = names(T{}); *name != nullptr; ++name) type.append(" ").append(*name);
    }
    return type;
  } else {
    const char kind = std::is_same_v<T, bool>       ? 'b'
                      : std::is_floating_point_v<T> ? 'f'
                      : std::is_signed_v<T>         ? 'i'
                                                    : 'u';
    return {kind, char('0' + sizeof(T))};
  }
}

// The shortest text that reads as the same number; an enumerator's name; JSON where JSON has such a value.
template <Number T>
std::string value_text(T x) {
  if constexpr (std::is_same_v<T, bool>) {
    return x ? "true" : "false";
  } else if constexpr (std::is_enum_v<T>) {
    if constexpr (requires { names(x); }) {
      auto left = std::uint64_t(x);
      for (const char* const* name = names(x); *name != nullptr; ++name) {
        if (left-- == 0) return std::string("\"").append(*name).append("\"");
      }
    }
    return value_text(std::underlying_type_t<T>(x));
  } else {
    if constexpr (std::is_floating_point_v<T>) {
      if (!std::isfinite(x)) return std::isnan(x) ? "\"nan\"" : x > 0 ? "\"inf\"" : "\"-inf\"";
    }
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, x).ptr};
  }
}

// A text as JSON.
inline std::string quoted(const std::string& s) {
  std::string text = "\"";
  for (const char c : s) {
    if (c == '"' || c == '\\') text += '\\';
    text += c >= 0 && c < ' ' ? ' ' : c;
  }
  return text += '"';
}

// Several numbers that are one thing, such as a vector.
template <Number T>
Leaf leaf_of(const std::string& path, const T* numbers, std::size_t count) {
  Leaf leaf{path, "", "["};
  for (std::size_t i = 0; i < count; ++i) {
    leaf.type.append(i == 0 ? "" : " ").append(type_name<T>());
    leaf.text.append(i == 0 ? "" : ", ").append(value_text(numbers[i]));
  }
  leaf.text += "]";
  return leaf;
}

inline std::string element_path(std::string path, std::size_t index) {
  return path.append("[").append(std::to_string(index)).append("]");
}
inline std::string part_path(std::string path, const char* name) {
  return path.append(path.empty() || *name == '\0' ? "" : ".").append(name);
}

template <class T>
void list_leaves(const T&, const std::string& path, Leaves&);

template <class T, std::size_t n>
void list_components(const std::array<T, n>& x, const std::string& path, Leaves& out) {
  for (std::size_t i = 0; i < n; ++i) list_leaves(x[i], element_path(path, i), out);
}
template <class Tag>
void list_components(const Handle<Tag>& h, const std::string& path, Leaves& out) {
  const std::uint32_t numbers[] = {h.index, std::uint32_t(h.generation)};
  out.push_back(leaf_of(path, numbers, 2));
}

// The visitor of describe().
struct LeafVisitor {
  const std::string& path;
  Leaves& out;
  template <class T, class Rule>
  void operator()(const char* name, const T& x, const Rule&) {
    list_leaves(x, part_path(path, name), out);
  }
};

// Numbers, what has a describe(), and what has a list_components().
template <class T>
void list_leaves(const T& x, const std::string& path, Leaves& out) {
  if constexpr (Number<T>) {
    out.push_back({path, type_name<T>(), value_text(x)});
  } else if constexpr (requires(LeafVisitor & v) { describe(v, x); }) {
    LeafVisitor visitor{path, out};
    describe(visitor, x);
  } else {
    list_components(x, path, out);
  }
}

// A type of plain data, for those who see only its bytes.
struct PlainType {
  std::size_t size;
  void (*leaves)(const void* value, Leaves&);
};
template <class T>
constexpr PlainType plain_type() {
  return {sizeof(T), [](const void* value, Leaves& out) { list_leaves(*static_cast<const T*>(value), "", out); }};
}

}
