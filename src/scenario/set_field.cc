// Settings by path, as text: the command line's --config, through the one description of Config.
#include <sudar/session.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>

namespace sudar::inline SUDAR_PRECISION {

namespace {

class FieldSetter {
 public:
  FieldSetter(std::string_view path, std::string_view value, std::string prefix = "")
      : path_(path), value_(value), prefix_(std::move(prefix)) {}

  template <class T, class Rule>
  requires std::is_arithmetic_v<T>
  void operator()(const char* name, T& field, const Rule&) {
    if (!is(name)) return;
    if constexpr (std::is_same_v<T, bool>) {
      if (value_ == "true" || value_ == "1")
        field = true;
      else if (value_ == "false" || value_ == "0")
        field = false;
      else
        refuse("true or false");
    } else {
      char* end = nullptr;
      const double x = std::strtod(value_.c_str(), &end);
      const bool number = !value_.empty() && *end == '\0' && !std::isnan(x);
      if constexpr (std::is_integral_v<T>) {
        constexpr double low = double(std::numeric_limits<T>::min()), high = double(std::numeric_limits<T>::max());
        if (!number || x < low || x > high || double(T(x)) != x) refuse("a whole number");
      } else if (!number) {
        refuse("a number");
      }
      field = T(x);
    }
  }
  template <class E, class Rule>
  requires std::is_enum_v<E>
  void operator()(const char* name, E& field, const Rule&) {
    if (!is(name)) return;
    std::string choices;
    for (int i = 0; names(E{})[i] != nullptr; ++i) {
      choices += (choices.empty() ? "" : ", ") + std::string(names(E{})[i]);
      if (value_ != names(E{})[i]) continue;
      field = E(i);
      return;
    }
    refuse("one of " + choices);
  }
  template <class T, class Rule>
  requires requires(FieldSetter& v, T& x) { describe(v, x); }
  void operator()(const char* name, T& field, const Rule&) {
    FieldSetter inner(path_, value_, prefix_ + name + ".");
    describe(inner, field);
    found_ |= inner.found_;
    known_ += inner.known_;
  }

  bool found() const { return found_; }
  const std::string& known() const { return known_; }

 private:
  bool is(const char* name) {
    const std::string full = prefix_ + name;
    known_ += (known_.empty() && prefix_.empty() ? "" : ", ") + full;
    if (full != path_) return false;
    return found_ = true;
  }
  [[noreturn]] void refuse(const std::string& expected) const {
    throw Error(path_, "is '" + value_ + "', must be " + expected);
  }
  std::string path_, value_, prefix_, known_;
  bool found_ = false;
};

class FieldLister {
 public:
  template <class T, class Rule>
  requires std::is_arithmetic_v<T>
  void operator()(const char* name, const T& field, const Rule&) {
    char text[32];
    std::snprintf(text, sizeof text, "%.17g", double(field));
    fields.emplace_back(prefix_ + name, text);
  }
  template <class Rule>
  void operator()(const char* name, const bool& field, const Rule&) {
    fields.emplace_back(prefix_ + name, field ? "true" : "false");
  }
  template <class E, class Rule>
  requires std::is_enum_v<E>
  void operator()(const char* name, const E& field, const Rule&) {
    fields.emplace_back(prefix_ + name, names(E{})[int(field)]);
  }
  template <class T, class Rule>
  requires requires(FieldLister& v, const T& x) { describe(v, x); }
  void operator()(const char* name, const T& field, const Rule&) {
    const std::string outer = prefix_;
    prefix_ += std::string(name) + ".";
    describe(*this, field);
    prefix_ = outer;
  }

  std::vector<std::pair<std::string, std::string>> fields;

 private:
  std::string prefix_;
};

}

void set_field(Config& config, std::string_view path, std::string_view value) {
  FieldSetter setter(path, value);
  Config changed = config;
  describe(setter, changed);
  if (!setter.found()) throw Error(std::string(path), "is no setting; there is: " + setter.known());
  config = changed;
}

std::vector<std::pair<std::string, std::string>> fields_of(const Config& config) {
  FieldLister lister;
  describe(lister, config);
  return std::move(lister.fields);
}

}
