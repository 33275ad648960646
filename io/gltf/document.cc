#include "io/gltf/document.h"

#include <algorithm>
#include <cstring>

namespace sudar::inline SUDAR_PRECISION::io::gltf {

namespace {

std::uint32_t word(std::span<const std::byte> bytes, std::size_t at) {  // little endian, on every machine
  std::uint32_t w = 0;
  for (std::size_t i = 4; i > 0; --i) w = w << 8 | std::uint32_t(bytes[at + i - 1]);
  return w;
}

int hex_digit(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

// "my%20mesh.bin" is a file "my mesh.bin" (RFC 3986, 2.1).
std::string unescaped(const std::string& uri) {
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const bool code = uri[i] == '%' && i + 2 < uri.size() && hex_digit(uri[i + 1]) >= 0 && hex_digit(uri[i + 2]) >= 0;
    name += code ? char(hex_digit(uri[i + 1]) * 16 + hex_digit(uri[i + 2])) : uri[i];
    i += code ? 2 : 0;
  }
  return name;
}

// RFC 4648, 4. None: it is not that.
std::optional<Bytes> from_base64(std::string_view text) {
  Bytes bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  int count = 0;
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  for (const char c : text) {
    const int six = c >= 'A' && c <= 'Z'   ? c - 'A'
                    : c >= 'a' && c <= 'z' ? c - 'a' + 26
                    : c >= '0' && c <= '9' ? c - '0' + 52
                    : c == '+'             ? 62
                    : c == '/'             ? 63
                                           : -1;
    if (six < 0) return {};
    bits = bits << 6 | std::uint32_t(six), count += 6;
    if (count >= 8) count -= 8, bytes.push_back(std::byte(bits >> count & 255));
  }
  return bytes;
}

struct Component {
  std::size_t size = 0;
  double scale = 1;  // what a normalised integer is divided by
  double (*number)(const std::byte*) = nullptr;
};
template <class T>
Component component() {
  return {sizeof(T), std::is_integral_v<T> ? double(std::numeric_limits<T>::max()) : 1, [](const std::byte* at) {
            T value;
            std::memcpy(&value, at, sizeof value);
            return double(value);
          }};
}
Component component_of(const JsonValue& type) {
  static_assert(std::endian::native == std::endian::little, "glTF's bytes are read as they lie");
  switch (type.whole()) {
    case 5120:
      return component<std::int8_t>();
    case 5121:
      return component<std::uint8_t>();
    case 5122:
      return component<std::int16_t>();
    case 5123:
      return component<std::uint16_t>();
    case 5125:
      return component<std::uint32_t>();
    case 5126:
      return component<float>();
    default:
      type.refuse("is no type of component");
  }
}

std::size_t components_of(const JsonValue& type) {
  static constexpr std::pair<const char*, std::size_t> counts[] = {
      {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& [name, count] : counts) {
    if (type.text() == name) return count;
  }
  type.refuse("is \"" + type.text() + "\": SCALAR, VEC2, VEC3 or VEC4 expected");
}

// `count` elements with `stride` bytes from one to the next lie within the bytes.
bool fits(std::size_t bytes, std::size_t offset, std::size_t count, std::size_t stride, std::size_t element) {
  if (count == 0) return true;
  if (offset > bytes || element > bytes - offset) return false;
  return (count - 1) <= (bytes - offset - element) / stride;
}

}

Document::Document(Source& source) : source_(source) {
  const bool binary = source.text().starts_with("glTF");
  const std::size_t first = source.text().find_first_not_of(" \t\r\n\xef\xbb\xbf");  // after a mark of the order of bytes
  if (!binary && (first == std::string_view::npos || source.text()[first] != '{')) {
    throw FileError({source.file().string(), 0, ""},
                    source.bytes().empty() ? "is empty" : "is no glTF: it begins neither as GLB nor as a JSON object");
  }
  json_.emplace(source, binary ? unpack() : source.text(), !binary);
  const std::string version = root()["asset"]["version"].text("");
  if (!version.starts_with("2.")) {
    root()["asset"]["version"].refuse(version.empty() ? "is left out: this is no glTF 2.0"
                                                      : "is " + version + ": only glTF 2 is read");
  }
  buffers_.resize(root()["buffers"].size());
}

// §4: a header of three words, then chunks: length, type, bytes. Returns the JSON.
std::string_view Document::unpack() {
  const Bytes& all = source_.bytes();
  const auto refuse = [&](const std::string& reason) { throw FileError({source_.file().string()}, reason); };
  if (all.size() < 20) refuse("is cut short: a GLB file has 20 bytes at least");
  if (word(all, 4) != 2) refuse("is GLB of version " + std::to_string(word(all, 4)) + ": only version 2 is read");
  if (word(all, 8) > all.size()) {
    refuse("is cut short: it has " + std::to_string(all.size()) + " of " + std::to_string(word(all, 8)) + " bytes");
  }
  constexpr std::uint32_t json = 0x4e4f534a, bin = 0x004e4942;
  std::string_view text;
  for (std::size_t at = 12; at + 8 <= all.size();) {
    const std::size_t size = word(all, at);
    const std::uint32_t type = word(all, at + 4);
    if (size > all.size() - at - 8) refuse("is cut short inside a chunk");
    const auto chunk = std::span(all).subspan(at + 8, size);
    if (at == 12 && type != json) refuse("does not begin with its JSON");
    if (at == 12)
      text = {reinterpret_cast<const char*>(chunk.data()), chunk.size()};
    else if (type == bin && binary_.empty())
      binary_ = chunk;
    at += 8 + size + (4 - size % 4) % 4;
  }
  return text;
}

JsonValue Document::element(const char* array, const JsonValue& index) const {
  const JsonValue list = root()[array];
  return list.element(index.index(list.size()));
}

std::span<const std::byte> Document::buffer(std::size_t i) {
  const JsonValue def = root()["buffers"].element(i), uri = def["uri"];
  const std::size_t length = def["byteLength"].whole();
  const auto cut = [&](std::span<const std::byte> bytes) {
    if (length > bytes.size()) {
      def.refuse("is cut short: it has " + std::to_string(bytes.size()) + " of " + std::to_string(length) + " bytes");
    }
    return bytes.subspan(0, length);
  };
  if (!uri) {
    if (i > 0 || binary_.empty()) def.refuse("has no uri and no binary chunk");
    return cut(binary_);
  }
  if (!buffers_[i]) {
    const std::string text = uri.text();
    if (text.starts_with("data:")) {
      const std::size_t comma = text.find(";base64,");
      if (comma != std::string::npos) buffers_[i] = from_base64(std::string_view(text).substr(comma + 8));
      if (!buffers_[i]) uri.refuse("is no base64 data");
    } else if (text.find("://") != std::string::npos) {
      uri.refuse("lies on the network: only files are read");
    } else {
      try {
        buffers_[i] = source_.read(source_.find(unescaped(text)));
      } catch (const Error& e) { uri.refuse(e.what()); }
    }
  }
  return cut(*buffers_[i]);
}

std::span<const std::byte> Document::view(const JsonValue& def) {
  const std::span<const std::byte> bytes = buffer(def["buffer"].index(buffers_.size()));
  const std::size_t offset = def["byteOffset"].whole(0), length = def["byteLength"].whole();
  if (offset > bytes.size() || length > bytes.size() - offset) def.refuse("ends outside its buffer");
  return bytes.subspan(offset, length);
}

std::vector<double> Document::numbers(const JsonValue& accessor, std::size_t components) {
  if (components_of(accessor["type"]) != components) {
    accessor["type"].refuse("is " + accessor["type"].text() + ": " + std::to_string(components) +
                            " numbers each expected");
  }
  const Component c = component_of(accessor["componentType"]);
  const double scale = accessor["normalized"].flag(false) ? 1 / c.scale : 1;
  const std::size_t count = accessor["count"].whole(), element = c.size * components;
  if (count > source_.options().limits.vertices * 3) accessor["count"].refuse("is more than the limits allow");

  const auto gather = [&](const JsonValue& where, const JsonValue& view_index, std::size_t offset, std::size_t n) {
    const JsonValue def = this->Document::element("bufferViews", view_index);
    if (def["extensions"]["EXT_meshopt_compression"]) def.refuse("is compressed by meshopt, which is not supported");
    const std::span<const std::byte> bytes = view(def);
    const std::size_t stride = std::max<std::size_t>(def["byteStride"].whole(element), 1);
    if (!fits(bytes.size(), offset, n, stride, element)) where.refuse("ends outside its buffer view");
    std::vector<double> list;
    list.reserve(n * components);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < components; ++k) {
        list.push_back(
            std::max(c.number(bytes.data() + offset + i * stride + k * c.size) * scale, scale == 1 ? -infinite : -1.0));
      }
    }
    return list;
  };

  std::vector<double> all(accessor["bufferView"] ? 0 : count * components);
  if (accessor["bufferView"]) all = gather(accessor, accessor["bufferView"], accessor["byteOffset"].whole(0), count);
  if (const JsonValue sparse = accessor["sparse"]) {  // §3.6.2.3: some elements are others
    const std::size_t n = sparse["count"].whole();
    if (n > count) sparse["count"].refuse("is more than the accessor has");
    const JsonValue at = sparse["indices"], values = sparse["values"];
    const Component ic = component_of(at["componentType"]);
    const std::span<const std::byte> bytes = view(this->Document::element("bufferViews", at["bufferView"]));
    const std::size_t first = at["byteOffset"].whole(0);
    if (!fits(bytes.size(), first, n, ic.size, ic.size)) at.refuse("ends outside its buffer view");
    const std::vector<double> others = gather(values, values["bufferView"], values["byteOffset"].whole(0), n);
    for (std::size_t i = 0; i < n; ++i) {
      const double target = ic.number(bytes.data() + first + i * ic.size);
      if (!(target >= 0 && target < double(count))) at.refuse("names an element that is not there");
      std::copy_n(others.begin() + std::ptrdiff_t(i * components), components,
                  all.begin() + std::ptrdiff_t(std::size_t(target) * components));
    }
  }
  return all;
}

std::vector<std::uint32_t> Document::indices(const JsonValue& accessor) {
  std::vector<std::uint32_t> list;
  for (const double x : numbers(accessor, 1)) {
    if (!(x >= 0 && x <= 0xffffffff && x == double(std::uint32_t(x)))) accessor.refuse("holds what is no index");
    list.push_back(std::uint32_t(x));
  }
  return list;
}

}
