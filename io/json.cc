#include "io/json.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

int line_at(std::string_view text, std::size_t at) {
  return 1 + int(std::count(text.begin(), text.begin() + std::ptrdiff_t(std::min(at, text.size())), '\n'));
}

// Walks over JSON that was parsed before, so that it need not doubt it.
class Walk {
 public:
  explicit Walk(std::string_view text, std::size_t at = 0) : text_(text), at_(at) {}

  // To where the value of that pointer begins; to what holds it where it is left out.
  std::size_t find(std::string_view pointer) {
    skip_space();
    while (!pointer.empty()) {
      const std::size_t end = std::min(pointer.find('/', 1), pointer.size()), here = at_;
      if (!enter(std::string(pointer.substr(1, end - 1)))) return here;
      pointer.remove_prefix(end);
    }
    return at_;
  }
  // Where the elements of the array begin at which it stands.
  std::vector<std::size_t> elements() {
    std::vector<std::size_t> list;
    if (now() != '[') return list;
    ++at_;
    while (skip_space(), at_ < text_.size() && now() != ']') {
      list.push_back(at_);
      skip_value();
      if (now() == ',') ++at_;
    }
    return list;
  }

 private:
  char now() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_space() {
    while (now() == ' ' || now() == '\n' || now() == '\r' || now() == '\t') ++at_;
  }
  std::string_view skip_string() {  // what is between the quotes, as it stands
    const std::size_t first = ++at_;
    for (; at_ < text_.size() && now() != '"'; ++at_) at_ += now() == '\\' ? 1 : 0;
    return text_.substr(first, at_++ - first);
  }
  void skip_value() {
    for (int depth = 0; at_ < text_.size();) {
      const char c = now();
      if (c == '"') {
        skip_string();
        continue;
      }
      const bool closes = c == ']' || c == '}';
      if (depth == 0 && (closes || c == ',')) return;
      depth += c == '[' || c == '{' ? 1 : closes ? -1 : 0;
      ++at_;
    }
  }
  bool enter(const std::string& part) {
    const bool object = now() == '{';
    if (!object && now() != '[') return false;
    ++at_;
    for (std::size_t i = 0; skip_space(), at_ < text_.size() && now() != ']' && now() != '}'; ++i) {
      std::string key = std::to_string(i);
      if (object) {
        key = skip_string();
        skip_space(), ++at_, skip_space();  // the colon
      }
      if (key == part) return true;
      skip_value();
      if (now() == ',') ++at_;
    }
    return false;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}

JsonFile::JsonFile(Source& source, std::string_view text, bool lines) : source_(source), text_(text), lines_(lines) {
  const std::size_t deepest = source.options().limits.nesting;
  const auto shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (depth >= 0 && std::size_t(depth) > deepest) {
      throw FileError({source.file().string(), 0, ""}, "is nested more than " + std::to_string(deepest) + " deep");
    }
    return true;
  };
  try {
    json_ = Json::parse(text.begin(), text.end(), shallow);
  } catch (const Json::parse_error& e) {
    throw FileError({source.file().string(), lines ? line_at(text, e.byte) : 0, ""},
                    "is not JSON: " + std::string(e.what()).substr(std::string(e.what()).find(']') + 2));
  } catch (const Json::exception& e) {
    throw FileError({source.file().string(), 0, ""}, "is not JSON: " + std::string(e.what()));
  }
  if (!json_.is_object()) throw FileError({source.file().string(), lines ? 1 : 0, ""}, "is no JSON object");
}

JsonValue JsonFile::root() const { return {*this, &json_, ""}; }

Origin JsonFile::origin(const std::string& pointer) const {
  const std::string file = source_.file().string();
  if (!lines_) return {file, 0, pointer};
  if (line_ends_.empty()) {
    for (std::size_t i = 0; i < text_.size(); ++i) {
      if (text_[i] == '\n') line_ends_.push_back(i);
    }
    line_ends_.push_back(text_.size());
  }
  std::size_t at = 0;
  const std::size_t second = pointer.find('/', 1), third = std::min(pointer.find('/', second + 1), pointer.size());
  const std::string array = pointer.substr(0, second);
  if (second != std::string::npos && !elements_.contains(array)) {
    elements_[array] = Walk(text_, Walk(text_).find(array)).elements();
  }
  const std::vector<std::size_t>* starts = second == std::string::npos ? nullptr : &elements_[array];
  std::size_t i = 0;
  if (starts != nullptr && std::from_chars(pointer.data() + second + 1, pointer.data() + third, i).ec == std::errc() &&
      i < starts->size()) {
    at = Walk(text_, (*starts)[i]).find(std::string_view(pointer).substr(third));
  } else {
    at = Walk(text_).find(pointer);
  }
  const auto line = std::lower_bound(line_ends_.begin(), line_ends_.end(), at) - line_ends_.begin();
  return {file, int(line) + 1, pointer};
}

void JsonValue::expect(bool right_type, const char* expected) const {
  if (value_ == nullptr) refuse(std::string("is left out: ") + expected + " expected");
  if (!right_type) refuse(std::string("is ") + value_->type_name() + ": " + expected + " expected");
}

JsonValue JsonValue::operator[](const std::string& key) const {
  const Json* member = nullptr;
  if (value_ != nullptr) {
    expect(value_->is_object(), "an object");
    if (const auto it = value_->find(key); it != value_->end()) member = &*it;
  }
  return {*file_, member, pointer_ + "/" + key};
}

std::vector<JsonValue> JsonValue::elements() const {
  std::vector<JsonValue> list;
  for (std::size_t i = 0; i < size(); ++i) list.push_back(element(i));
  return list;
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
  std::vector<std::pair<std::string, JsonValue>> list;
  if (value_ == nullptr) return list;
  expect(value_->is_object(), "an object");
  for (auto it = value_->begin(); it != value_->end(); ++it) list.emplace_back(it.key(), (*this)[it.key()]);
  return list;
}

std::size_t JsonValue::size() const {
  if (value_ == nullptr) return 0;
  expect(value_->is_array(), "an array");
  return value_->size();
}

JsonValue JsonValue::element(std::size_t i) const {
  if (i >= size()) refuse("has no element " + std::to_string(i));
  return {*file_, &(*value_)[i], pointer_ + "/" + std::to_string(i)};
}

double JsonValue::number() const {
  expect(value_ != nullptr && value_->is_number(), "a number");
  const double x = value_->get<double>();
  if (!std::isfinite(x)) refuse("is not finite");
  return x;
}

double JsonValue::number_from(double low, double otherwise) const {
  const double x = number(otherwise);
  if (x < low) refuse("is " + value_->dump() + ", less than " + Json(low).dump());
  return x;
}

bool JsonValue::flag(bool otherwise) const {
  if (!*this) return otherwise;
  expect(value_->is_boolean(), "true or false");
  return value_->get<bool>();
}

std::string JsonValue::text() const {
  expect(value_ != nullptr && value_->is_string(), "a text");
  return value_->get<std::string>();
}

std::size_t JsonValue::whole() const {
  // Some writers give 3.0 for 3.
  const double x = number();
  if (!(x >= 0 && x < 0x1p53 && x == std::floor(x)))
    refuse("is " + value_->dump() + ": a whole number of at least 0 expected");
  return std::size_t(x);
}

std::size_t JsonValue::index(std::size_t count) const {
  const std::size_t i = whole();
  if (i >= count) refuse("is " + std::to_string(i) + ", but there are " + std::to_string(count) + " of them");
  return i;
}

std::vector<double> JsonValue::numbers(std::size_t count) const {
  expect(value_ != nullptr && value_->is_array() && value_->size() == count,
         ("an array of " + std::to_string(count) + " numbers").c_str());
  std::vector<double> list;
  for (const JsonValue& v : elements()) list.push_back(v.number());
  return list;
}

Vec3d JsonValue::vector(const Vec3d& otherwise) const {
  if (!*this) return otherwise;
  const std::vector<double> v = numbers(3);
  return {v[0], v[1], v[2]};
}

Quatd JsonValue::rotation() const {
  if (!*this) return {};
  const std::vector<double> v = numbers(4);
  const Quatd q{v[0], v[1], v[2], v[3]};
  const double square = length_squared(q);
  if (!(square > 1e-12 && square < 1e12)) refuse("is no rotation: a quaternion of length 1 expected");
  return normalize(q);
}

}
