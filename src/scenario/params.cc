#include <sudar/scenario.h>

#include <algorithm>

#include "base/archive.h"
#include "base/text.h"

namespace sudar::inline SUDAR_PRECISION {

double Params::visit(std::string_view name, Kind kind, double value, double low, double high, std::string_view about) {
  if (const auto given = values_.find(std::string(name)); given != values_.end()) {
    value = given->second;
    const bool whole = std::floor(value) == value;
    if (!(value >= low && value <= high) || (kind != Kind::real && !whole)) {
      throw Error(std::string(name), "is " + text(value) + ", must be " +
                                         (kind == Kind::real ? "" : "a whole number ") + "from " + text(low) + " to " +
                                         text(high));
    }
  }
  entries_.push_back({std::string(name), kind, value, low, high, std::string(about)});
  return value;
}

void Params::operator()(std::string_view name, int& value, int low, int high, std::string_view about) {
  value = int(visit(name, Kind::integer, value, low, high, about));
}
void Params::operator()(std::string_view name, float& value, double low, double high, std::string_view about) {
  value = float(visit(name, Kind::real, double(value), low, high, about));
}
void Params::operator()(std::string_view name, double& value, double low, double high, std::string_view about) {
  value = visit(name, Kind::real, value, low, high, about);
}
void Params::operator()(std::string_view name, bool& value, std::string_view about) {
  value = visit(name, Kind::boolean, value ? 1 : 0, 0, 1, about) != 0;
}

void Params::require_all_known() const {
  for (const auto& [name, value] : values_) {
    const auto is = [&wanted = name](const Entry& e) { return e.name == wanted; };  // clang 14 captures no bindings
    if (std::any_of(entries_.begin(), entries_.end(), is)) continue;
    std::string there;
    for (const Entry& e : entries_) there += (there.empty() ? "" : ", ") + e.name;
    throw Error(name,
                "is no parameter of this scenario" + (there.empty() ? ", which has none" : "; there is: " + there));
  }
}

void State::raw(std::string_view name, void* data, std::size_t size) {
  if (reading_) {
    if (size > bytes_.size() - position_) missing(name);
    if (size > 0) std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
  } else {
    const auto* p = static_cast<const std::byte*>(data);
    bytes_.insert(bytes_.end(), p, p + size);
  }
}

void State::missing(std::string_view name) {
  throw Error(std::string(name), "is missing in the saved state of the scenario");
}

bool Input::held(std::string_view key) const { return std::find(held_.begin(), held_.end(), key) != held_.end(); }
bool Input::pressed(std::string_view key) const {
  return std::find(pressed_.begin(), pressed_.end(), key) != pressed_.end();
}
void Input::set(std::vector<std::string> keys) {
  for (const std::string& key : keys) {
    if (!held(key)) pressed_.push_back(key);
  }
  held_ = std::move(keys);
}

bool Input::is_key(std::string_view key) {
  const auto within = [](char c, char low, char high) { return c >= low && c <= high; };
  if (key.size() == 1) return within(key[0], 'a', 'z') || within(key[0], '0', '9');
  const std::string list = std::string(", ") + named_keys + ", ";
  return key.find(',') == std::string_view::npos && list.find(", " + std::string(key) + ", ") != std::string::npos;
}

Bytes Input::save() const {
  ByteWriter w;
  for (const auto* keys : {&held_, &pressed_}) {
    w.value(std::uint64_t(keys->size()));
    for (const std::string& key : *keys) w.text(key);
  }
  w.value(view.x), w.value(view.y), w.value(view.z);
  return w.take();
}

void Input::load(const Bytes& bytes) {
  Reader r(bytes);
  for (auto* keys : {&held_, &pressed_}) {
    keys->resize(r.count(1));
    for (std::string& key : *keys) key = r.text();
  }
  view.x = r.value<Real>(), view.y = r.value<Real>(), view.z = r.value<Real>();
}

std::string abi_of_this_engine() { return abi_of_this_file(); }

}
