#include <cctype>

#include "bind.h"
#include "definition.h"

namespace sudar::python {

std::string lower_case(std::string s) {
  for (char& c : s) c = char(std::tolower(static_cast<unsigned char>(c)));
  return s;
}

std::string text_of(std::string_view definition, std::string_view field) {
  for (const FieldText& t : field_texts()) {
    if (t.definition == definition && t.field == field) return t.text;
  }
  return {};
}

namespace {
template <class... T>
void bind_alternatives(py::module_& m, const std::variant<T...>*) {
  (bind_definition<T>(m), ...);
}
}

void bind_definitions(py::module_& m) {
  bind_definition<BodyDef>(m);
  bind_alternatives(m, static_cast<JointDef*>(nullptr));
  bind_alternatives(m, static_cast<Force*>(nullptr));
  bind_definition<Sensor>(m);
  bind_definition<Config>(m);
}

}
