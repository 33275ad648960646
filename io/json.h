// A JSON file as readers ask for it: every value knows where it stands, and what is of the wrong type or out of range
// is refused by its pointer and line.
#pragma once

#include <map>

#include <nlohmann/json.hpp>

#include "io/source.h"

namespace sudar::inline SUDAR_PRECISION::io {

using Json = nlohmann::json;

class JsonValue;

// Outlives the values that it gives.
class JsonFile {
 public:
  // Throws FileError: no JSON, or nested deeper than the limits allow. `lines`: whether the text has lines that tell
  // something, which one inside a binary file has not.
  JsonFile(Source&, std::string_view text, bool lines);
  JsonValue root() const;
  Origin origin(const std::string& pointer) const;
  Source& source() const { return source_; }

 private:
  Source& source_;
  std::string_view text_;
  bool lines_;
  Json json_;
  // Where the elements of the arrays in the root begin, found when the first of them is asked for.
  mutable std::map<std::string, std::vector<std::size_t>> elements_;
  mutable std::vector<std::size_t> line_ends_;
};

// A value of the file, or one that is left out.
class JsonValue {
 public:
  JsonValue(const JsonFile& file, const Json* value, std::string pointer)
      : file_(&file), value_(value), pointer_(std::move(pointer)) {}

  explicit operator bool() const { return value_ != nullptr; }
  // A member of an object; left out where that is or has none. Refuses what is no object.
  JsonValue operator[](const std::string& key) const;
  // The elements of an array; none where it is left out. Refuses what is no array.
  std::vector<JsonValue> elements() const;
  std::vector<std::pair<std::string, JsonValue>> members() const;
  JsonValue element(std::size_t i) const;  // refuses what is not there
  std::size_t size() const;                // of an array; 0 where it is left out

  // Each refuses another type, a number that is not finite, and, where there is no other value, what is left out.
  double number() const;
  double number(double otherwise) const { return *this ? number() : otherwise; }
  double number_from(double low, double otherwise) const;  // not below `low`
  bool flag(bool otherwise) const;
  std::string text() const;
  std::string text(const std::string& otherwise) const { return *this ? text() : otherwise; }
  std::size_t whole() const;  // ≥ 0
  std::size_t whole(std::size_t otherwise) const { return *this ? whole() : otherwise; }
  std::size_t index(std::size_t count) const;  // of one of so many
  Vec3d vector(const Vec3d& otherwise) const;  // [x, y, z]
  Quatd rotation() const;                      // [x, y, z, w], normalised; the identity where it is left out

  Origin origin() const { return file_->origin(pointer_); }
  const std::string& pointer() const { return pointer_; }
  [[noreturn]] void refuse(const std::string& reason) const { throw FileError(origin(), reason); }
  void warn(std::string message) const { file_->source().warn(origin(), std::move(message)); }
  void note(std::string message) const { file_->source().note(origin(), std::move(message)); }

 private:
  void expect(bool right_type, const char* expected) const;
  std::vector<double> numbers(std::size_t count) const;

  const JsonFile* file_;
  const Json* value_;
  std::string pointer_;
};

}
