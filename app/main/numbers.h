// The numbers of the command line: each is looked at here, for what it is and for its range. Not finite is no number.
#pragma once

#include <sudar/definitions.h>

#include <CLI/App.hpp>

namespace sudar::app {

inline constexpr Range simulated_time{0, 1e12};  // s: thirty thousand years, for those who watch planets

// A number within the range and nothing else. Throw Error naming `what`, what was given and what was expected.
double parse_number(const std::string& what, const std::string& text, const Range& = any);
std::int64_t parse_whole(const std::string& what, const std::string& text, std::int64_t low, std::int64_t high);

// "1280x720" → 1280, 720.
std::pair<int, int> parse_size(const std::string&);

// Options that are numbers. `name`: "--fps".
CLI::Option* add_number(CLI::App&, const std::string& name, std::optional<double>& value, const Range&,
                        const std::string& about);
template <class T>
CLI::Option* add_whole(CLI::App& app, const std::string& name, T& value, std::int64_t low, std::int64_t high,
                       const std::string& about) {
  return app.add_option_function<std::string>(
      name, [&value, name, low, high](const std::string& text) { value = T(parse_whole(name, text, low, high)); }, about);
}

}
