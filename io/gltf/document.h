// A glTF 2.0 document: its JSON, its buffers, and what accessors see in them. Numbers of the paragraphs are those of
// the specification (Khronos, glTF 2.0.1, 2021).
#pragma once

#include "io/json.h"

namespace sudar::inline SUDAR_PRECISION::io::gltf {

class Document {
 public:
  // Of .gltf or .glb, told by what it begins with. Throws FileError.
  explicit Document(Source&);

  JsonValue root() const { return json_->root(); }
  JsonValue element(const char* array,
                    const JsonValue& index) const;  // of a list of the root, by a value that says which
  Source& source() const { return source_; }

  // The elements of an accessor with so many components, as numbers: components × count of them. Normalised integers
  // are fractions (§3.6.2.2).
  std::vector<double> numbers(const JsonValue& accessor, std::size_t components);
  std::vector<std::uint32_t> indices(const JsonValue& accessor);

 private:
  std::span<const std::byte> buffer(std::size_t);
  std::span<const std::byte> view(const JsonValue& view);
  std::string_view unpack();

  Source& source_;
  std::span<const std::byte> binary_;  // chunk of a GLB file
  std::vector<std::optional<Bytes>> buffers_;
  std::optional<JsonFile> json_;
};

}
