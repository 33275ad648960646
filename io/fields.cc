#include "io/fields.h"

#include <algorithm>
#include <charconv>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

constexpr std::string_view spaces = " \t\r\n";

// Those that there are, but no more than that.
std::vector<std::string_view> words(std::string_view text, std::size_t most) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t begin = text.find_first_not_of(spaces);
    if (begin == std::string_view::npos || result.size() == most) return result;
    const std::size_t end = std::min(text.find_first_of(spaces, begin), text.size());
    result.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
}

// Of numbers that can be worked with, fourth powers are finite.
constexpr double largest = 1e60;

// Finite numbers alone: no file means "nan" or "inf".
std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double x = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), x);
  if (error != std::errc() || stop != word.data() + word.size() || !(abs(x) <= largest)) return {};
  return x;
}

std::string shown(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 6).ptr;
  return std::string(buffer, end);
}

}

void Remarks::add(Severity severity, const Origin& at, const std::string& message) {
  const auto [it, fresh] = known_.emplace(message, remarks_.size());
  if (fresh)
    remarks_.push_back({severity, at, message});
  else
    ++remarks_[it->second].more;
}

void Remarks::tell() {
  for (Remark& r : remarks_) {
    if (r.more > 0) r.message += r.more == 1 ? " (and once more)" : " (and " + std::to_string(r.more) + " times more)";
    if (r.severity == Severity::note)
      source_.note(std::move(r.at), std::move(r.message));
    else
      source_.warn(std::move(r.at), std::move(r.message));
  }
  remarks_.clear(), known_.clear();
}

const XmlAttribute* Fields::find(std::string_view name) const {
  const auto it = std::find_if(attributes_.begin(), attributes_.end(), [&](const auto& a) { return a.name == name; });
  return it == attributes_.end() ? nullptr : &*it;
}

const XmlAttribute* Fields::ask(std::string_view name) {
  const XmlAttribute* a = find(name);
  if (a != nullptr) asked_[std::size_t(a - attributes_.data())] = 1;
  return a;
}

Origin Fields::at(std::string_view name) const {
  const XmlAttribute* a = find(name);
  return a != nullptr ? a->at : at_;
}

std::string Fields::text(std::string_view name, std::string otherwise) {
  const XmlAttribute* a = ask(name);
  return a != nullptr ? a->value : otherwise;
}

std::vector<double> Fields::numbers(std::string_view name, std::size_t least, std::size_t most) {
  const XmlAttribute* a = ask(name);
  if (a == nullptr) return {};
  const std::vector<std::string_view> all = words(a->value, most + 1);
  if (all.size() < least || all.size() > most) {
    const std::string upper = most == least ? "" : most == unbounded ? " or more" : " to " + std::to_string(most);
    fail(name, "has " + std::to_string(all.size()) + (all.size() > most ? " or more" : "") + " numbers, must have " +
                   std::to_string(least) + upper);
  }
  std::vector<double> result;
  for (const std::string_view word : all) {
    const std::optional<double> x = number_of(word);
    if (!x) fail(name, in_quotes(word) + " is no number that can be worked with");
    result.push_back(*x);
  }
  return result;
}

double Fields::number(std::string_view name, double otherwise, const Range& range) {
  if (!has(name)) return otherwise;
  const double x = numbers(name, 1, 1)[0];
  if (x < range.low || x > range.high || (range.above && x == range.low)) {
    fail(name, "is " + shown(x) + ", must be " +
                   (range.above ? "above " + shown(range.low) : "at least " + shown(range.low)) +
                   (range.high < greatest ? " and at most " + shown(range.high) : ""));
  }
  return x;
}

std::int64_t Fields::whole(std::string_view name, std::int64_t otherwise, std::int64_t low, std::int64_t high) {
  const double x = number(name, double(otherwise), {double(low), double(high)});
  if (double(std::int64_t(x)) != x) fail(name, "is " + shown(x) + ", must be a whole number");
  return std::int64_t(x);
}

bool Fields::flag(std::string_view name, bool otherwise) {
  return choice(name, otherwise ? 1 : 0, {"false", "true"}) == 1;
}

std::size_t Fields::choice(std::string_view name, std::size_t otherwise,
                           std::initializer_list<std::string_view> choices) {
  const XmlAttribute* a = ask(name);
  if (a == nullptr) return otherwise;
  const auto it = std::find(choices.begin(), choices.end(), a->value);
  if (it != choices.end()) return std::size_t(it - choices.begin());
  std::string list;
  for (const std::string_view c : choices) list.append(list.empty() ? "" : ", ").append(c);
  fail(name, "is " + in_quotes(a->value) + ", must be one of " + list);
}

Vec3d Fields::vector(std::string_view name, const Vec3d& otherwise) {
  const std::vector<double> x = numbers(name, 3, 3);
  return x.empty() ? otherwise : Vec3d{x[0], x[1], x[2]};
}

Vec3d Fields::direction(std::string_view name, const Vec3d& otherwise) {
  const Vec3d v = vector(name, otherwise);
  const double l = length(v);
  if (!(l > 1e-9) || !std::isfinite(l)) fail(name, "has no direction");
  return v / l;
}

void Fields::pass(std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) ask(name);
}

void Fields::leave_out(std::string_view name, const std::string& message) {
  if (ask(name) != nullptr) remarks_.warn(at(name), in_quotes(name).append(" ").append(message));
}

void Fields::mention(std::string_view name, const std::string& message) {
  if (ask(name) != nullptr) remarks_.note(at(name), in_quotes(name).append(" ").append(message));
}

void Fields::finish() {
  for (std::size_t i = 0; i < attributes_.size(); ++i) {
    if (!asked_[i])
      remarks_.warn(attributes_[i].at,
                    "the attribute " + in_quotes(attributes_[i].name) + " is not known, and left out");
  }
}

}
