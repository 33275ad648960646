// Attributes of an XML element, read as numbers, vectors and choices, each error with its line. What nobody asked for
// is found out, so that nothing is passed over in silence.
#pragma once

#include <map>

#include "io/xml.h"

namespace sudar::inline SUDAR_PRECISION::io {

// Findings of which a file may give hundreds alike: told once, where the first is, with their number.
class Remarks {
 public:
  explicit Remarks(Source& source) : source_(source) {}
  void note(const Origin& at, const std::string& message) { add(Severity::note, at, message); }
  void warn(const Origin& at, const std::string& message) { add(Severity::warning, at, message); }
  void tell();  // the source, in the order in which they were first met

 private:
  struct Remark {
    Severity severity;
    Origin at;
    std::string message;
    std::size_t more = 0;
  };
  void add(Severity, const Origin&, const std::string& message);
  Source& source_;
  std::vector<Remark> remarks_;
  std::map<std::string, std::size_t> known_;  // by message
};

class Fields {
 public:
  static constexpr std::size_t unbounded = 30'000'000;
  // The attributes may be others than the element's own: with its defaults.
  Fields(Remarks& remarks, const Origin& element, std::vector<XmlAttribute> attributes)
      : remarks_(remarks), at_(element), attributes_(std::move(attributes)), asked_(attributes_.size()) {}
  Fields(Remarks& remarks, const XmlElement& e) : Fields(remarks, e.at, e.attributes) {}

  bool has(std::string_view name) const { return find(name) != nullptr; }
  std::string text(std::string_view name, std::string otherwise = {});
  double number(std::string_view name, double otherwise, const Range& = any_finite);
  std::int64_t whole(std::string_view name, std::int64_t otherwise, std::int64_t low, std::int64_t high);
  bool flag(std::string_view name, bool otherwise);  // "true" or "false"
  // Its place among the choices.
  std::size_t choice(std::string_view name, std::size_t otherwise, std::initializer_list<std::string_view> choices);
  // From `least` to `most` numbers; none where there is no such attribute.
  std::vector<double> numbers(std::string_view name, std::size_t least, std::size_t most);
  Vec3d vector(std::string_view name, const Vec3d& otherwise = {});
  Vec3d direction(std::string_view name, const Vec3d& otherwise);  // made to have length 1

  // Attributes that change nothing of what is made here: looks, names of looks.
  void pass(std::initializer_list<std::string_view> names);
  // One that would, but is not supported; `mention`: and hardly matters.
  void leave_out(std::string_view name, const std::string& message);
  void mention(std::string_view name, const std::string& message);
  // Warns of each attribute that nobody asked for.
  void finish();

  Origin at(std::string_view name) const;  // the attribute where it is there, else the element
  const Origin& at() const { return at_; }
  [[noreturn]] void fail(std::string_view name, const std::string& reason) const { throw FileError(at(name), reason); }

 private:
  const XmlAttribute* find(std::string_view name) const;
  const XmlAttribute* ask(std::string_view name);
  Remarks& remarks_;
  Origin at_;
  std::vector<XmlAttribute> attributes_;
  std::vector<char> asked_;
};

}
