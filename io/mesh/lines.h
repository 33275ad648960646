// Words of a text, line by line.
#pragma once

#include <sudar/io.h>

#include <charconv>

namespace sudar::inline SUDAR_PRECISION::io {

class Lines {
 public:
  Lines(std::string file, std::span<const std::byte> bytes)
      : file_(std::move(file)), rest_(reinterpret_cast<const char*>(bytes.data()), bytes.size()) {}

  // The next line's words; none: the text is over. What follows a '#' is left out, and a '\\' at the end goes on.
  bool next(std::vector<std::string_view>& words) {
    words.clear();
    if (rest_.empty()) return false;
    for (bool more = true; more && !rest_.empty();) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      line = line.substr(0, line.find('#'));
      while (!line.empty() && is_space(line.back())) line.remove_suffix(1);
      more = !line.empty() && line.back() == '\\';
      if (more) line.remove_suffix(1);
      while (!line.empty()) {
        while (!line.empty() && is_space(line.front())) line.remove_prefix(1);
        std::size_t size = 0;
        while (size < line.size() && !is_space(line[size])) ++size;
        if (size > 0) words.push_back(line.substr(0, size));
        line.remove_prefix(size);
      }
    }
    return true;
  }
  std::string_view rest() const { return rest_; }
  Origin here() const { return {file_, number_, ""}; }
  [[noreturn]] void refuse(const std::string& reason) const { throw FileError(here(), reason); }

  double number(std::string_view word) const {
    if (word.starts_with('+')) word.remove_prefix(1);
    double x = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(x)) {
      refuse("\"" + std::string(word.substr(0, 40)) + "\" given, a number expected");
    }
    return x;
  }
  std::int64_t whole(std::string_view word) const {
    std::int64_t i = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), i);
    if (error != std::errc() || end != word.data() + word.size()) {
      refuse("\"" + std::string(word.substr(0, 40)) + "\" given, a whole number expected");
    }
    return i;
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }
  std::string file_;
  std::string_view rest_;
  int number_ = 0;
};

}
