#include "main/numbers.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace sudar::app {

namespace {

template <class T>
bool read_all(const std::string& text, T& number) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end;
}

std::string text(double x) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", x);
  return buffer;
}

// Bounds that only the largest numbers reach are worth telling to whom has given one.
std::string expected(const Range& r, bool given_a_number) {
  const auto tells = [&](double bound) { return std::isfinite(bound) && (given_a_number || std::abs(bound) < greatest); };
  const bool low = tells(r.low), high = tells(r.high);
  if (low && high) return "a number from " + text(r.low) + " to " + text(r.high);
  if (low) return std::string("a number ") + (r.above ? "above " : "from ") + text(r.low) + (r.above ? "" : " on");
  return "a number";
}

}

double parse_number(const std::string& what, const std::string& given, const Range& range) {
  double x = 0;
  const bool number = read_all(given, x) && std::isfinite(x);
  const bool good = number && x >= range.low && x <= range.high && !(range.above && x == range.low);
  if (!good) throw Error(what, "\"" + given + "\" given, " + expected(range, number) + " expected");
  return x;
}

std::int64_t parse_whole(const std::string& what, const std::string& given, std::int64_t low, std::int64_t high) {
  std::int64_t n = 0;
  if (!read_all(given, n) || n < low || n > high) {
    throw Error(what, "\"" + given + "\" given, a whole number from " + std::to_string(low) + " to " +
                          std::to_string(high) + " expected");
  }
  return n;
}

std::pair<int, int> parse_size(const std::string& given) {
  constexpr int low = 16, high = 8192;
  try {
    const std::size_t cross = std::min(given.find('x'), given.size() - 1);
    return {int(parse_whole("--size", given.substr(0, cross), low, high)),
            int(parse_whole("--size", given.substr(cross + 1), low, high))};
  } catch (const Error&) {
    throw Error("--size", "\"" + given + "\" given, WIDTHxHEIGHT expected, each from 16 to 8192");
  }
}

CLI::Option* add_number(CLI::App& app, const std::string& name, std::optional<double>& value, const Range& range,
                        const std::string& about) {
  return app.add_option_function<std::string>(
      name, [&value, name, range](const std::string& given) { value = parse_number(name, given, range); }, about);
}

}
