// Any aggregate that has a describe() (sudar/definitions.h) as a Python class: keyword arguments, attributes, repr, ==,
// and errors that name the field. A field added there appears here by itself, with the comment beside it as its text.
#pragma once

#include <algorithm>

#include "convert.h"
#include "described.h"

namespace sudar::python {

template <class T>
struct TagOf {};
template <class Tag>
struct TagOf<Handle<Tag>> {
  using Type = Tag;
};

// What the comments say: made from the header by field_texts.py.
struct FieldText {
  const char *definition, *field, *text;
};
std::span<const FieldText> field_texts();
std::string text_of(std::string_view definition, std::string_view field);  // field: empty for the definition itself

// The type as a stub writes it, and as an error names it.
template <class F>
std::string type_name() {
  if constexpr (OptionalOf<F>::value)
    return "Optional[" + type_name<typename OptionalOf<F>::Type>() + "]";
  else if constexpr (VectorOf<F>::value)
    return "Sequence[" + type_name<typename VectorOf<F>::Type>() + "]";
  else if constexpr (std::is_same_v<F, bool>)
    return "bool";
  else if constexpr (std::is_integral_v<F>)
    return "int";
  else if constexpr (std::is_arithmetic_v<F>)
    return "float";
  else if constexpr (std::is_same_v<F, std::string>)
    return "str";
  else if constexpr (std::is_enum_v<F>) {
    std::string all;
    for (int i = 0; names(F{})[i]; ++i) all += (i ? ", \"" : "\"") + std::string(names(F{})[i]) + "\"";
    return "Literal[" + all + "]";
  } else if constexpr (Numeric<F>) {
    return Numbers<F>::columns == 3 ? "Matrix" : Numbers<F>::rows == 4 ? "Quaternion" : "Vector";
  } else if constexpr (requires { F{}.null(); }) {
    return "Optional[" + py::type::of<Bound<typename TagOf<F>::Type>>().attr("__name__").template cast<std::string>() +
           "]";
  } else {
    return py::type::of<F>().attr("__name__").template cast<std::string>();
  }
}

template <class T>
void set_fields(T& definition, const py::kwargs& values, const std::string& path);

template <class F>
F read_field(py::handle value, const std::string& path) {
  if constexpr (OptionalOf<F>::value) {
    if (value.is_none()) return std::nullopt;
    return read_field<typename OptionalOf<F>::Type>(value, path);
  } else if constexpr (VectorOf<F>::value) {
    if (!py::isinstance<py::sequence>(value))
      throw Error(path, "is " + py::repr(value).cast<std::string>() + ", expected a sequence");
    F all;
    for (const py::handle one : py::reinterpret_borrow<py::sequence>(value)) {
      all.push_back(read_field<typename VectorOf<F>::Type>(one, path + "[" + std::to_string(all.size()) + "]"));
    }
    return all;
  } else {
    if constexpr (Described<F>) {
      if (py::isinstance<py::dict>(value)) {
        F field{};
        set_fields(field, py::reinterpret_borrow<py::kwargs>(value), path.empty() ? path : path + ".");
        return field;
      }
    }
    py::detail::make_caster<F> caster;
    constexpr bool none_is_one = requires { F{}.null(); };  // of a handle, not of a class like Shape
    // Without conversion: else "no" would be a true bool.
    if ((value.is_none() && !none_is_one) || !caster.load(value, !std::is_same_v<F, bool>)) {
      throw Error(path, "is " + py::repr(value).cast<std::string>() + ", expected " + type_name<F>() +
                            (Described<F> ? " or a dict of its fields" : ""));
    }
    return py::detail::cast_op<F>(std::move(caster));
  }
}

template <class T>
class FieldSetter {
 public:
  FieldSetter(std::string_view name, py::handle value, const std::string& path)
      : name_(name), value_(value), path_(path) {}
  template <class F, class Rule>
  void operator()(const char* name, F& field, const Rule&) {
    if (name_ == name) field = read_field<F>(value_, path_ + name), found = true;
  }
  bool found = false;

 private:
  std::string_view name_;
  py::handle value_;
  const std::string& path_;
};

class FieldGetter {
 public:
  FieldGetter(std::string_view name, py::handle owner) : name_(name), owner_(owner) {}
  template <class F, class Rule>
  void operator()(const char* name, F& field, const Rule&) {
    if (name_ != name) return;
    value = cast(field);
  }
  py::object value = py::none();

 private:
  // A definition in a definition is the same object, so that d.material.restitution = 1 does what it says. Of several
  // a tuple of copies is given.
  template <class F>
  py::object cast(F& field) {
    if constexpr (OptionalOf<std::remove_const_t<F>>::value) {
      return field ? cast(*field) : py::object(py::none());
    } else if constexpr (VectorOf<std::remove_const_t<F>>::value) {
      return py::tuple(py::cast(field));
    } else if constexpr (Described<F>) {
      return py::cast(&field, py::return_value_policy::reference_internal, owner_);
    } else {
      return py::cast(field);
    }
  }
  std::string_view name_;
  py::handle owner_;
};

// A list of the fields: (name, type, default, text).
class FieldLister {
 public:
  explicit FieldLister(std::string_view definition) : definition_(definition) {}
  template <class F, class Rule>
  void operator()(const char* name, const F& field, const Rule&) {
    fields.append(py::make_tuple(name, type_name<F>(), py::repr(py::cast(field)), text_of(definition_, name)));
  }
  py::list fields;

 private:
  std::string_view definition_;
};

// Compares field by field: the second object's lie where the first one's do.
class FieldComparer {
 public:
  FieldComparer(const void* a, const void* b) : way_(static_cast<const char*>(b) - static_cast<const char*>(a)) {}
  template <class F, class Rule>
  void operator()(const char*, const F& a, const Rule&) {
    const F& b = *reinterpret_cast<const F*>(reinterpret_cast<const char*>(&a) + way_);
    equal = equal && same(a, b);
  }
  bool equal = true;

  template <class F>
  static bool same(const F& a, const F& b) {
    if constexpr (Described<const F>) {
      FieldComparer inner(&a, &b);
      describe(inner, a);
      return inner.equal;
    } else if constexpr (OptionalOf<F>::value) {
      return a.has_value() == b.has_value() && (!a || same(*a, *b));
    } else if constexpr (VectorOf<F>::value) {
      return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                        [](const auto& x, const auto& y) { return same(x, y); });
    } else {
      return a == b;
    }
  }

 private:
  std::ptrdiff_t way_;
};

template <class T>
py::list fields_of(const std::string& name) {
  FieldLister lister(name);
  const T defaults{};
  describe(lister, defaults);
  return lister.fields;
}

template <class T>
void set_fields(T& definition, const py::kwargs& values, const std::string& path) {
  for (const auto& [key, value] : values) {
    const std::string name = py::str(key);
    FieldSetter<T> setter(name, value, path);
    describe(setter, definition);
    if (setter.found) continue;
    const std::string type = py::type::of<T>().attr("__name__").template cast<std::string>();
    std::string known;
    for (const py::handle field : fields_of<T>(type)) {
      known += (known.empty() ? "" : ", ") + field.cast<py::tuple>()[0].cast<std::string>();
    }
    throw py::type_error(path + name + ": is no field of " + type + ", which has " + known);
  }
}

template <class T>
T from_keywords(const py::kwargs& values, const std::string& path = "") {
  T definition{};
  set_fields(definition, values, path);
  return definition;
}

// Name(field=…): those that differ from the defaults.
template <class T>
std::string repr_of(const std::string& name, T& definition) {
  T defaults{};
  std::string text;
  for (const py::handle entry : fields_of<T>(name)) {
    const auto field = entry.cast<py::tuple>()[0].cast<std::string>();
    FieldGetter now(field, py::none()), before(field, py::none());
    describe(now, definition), describe(before, defaults);
    const auto value = py::repr(now.value).cast<std::string>();
    if (value != py::repr(before.value).cast<std::string>()) text += (text.empty() ? "" : ", ") + field + "=" + value;
  }
  return name + "(" + text + ")";
}

std::string lower_case(std::string);

template <class T>
void bind_definition(py::module_& m);

// Makes the classes of the definitions that are fields of others.
class PartBinder {
 public:
  explicit PartBinder(py::module_& m) : module_(m) {}
  template <class F, class Rule>
  void operator()(const char*, const F&, const Rule&) {
    if constexpr (OptionalOf<F>::value)
      (*this)("", typename OptionalOf<F>::Type{}, any);
    else if constexpr (VectorOf<F>::value)
      (*this)("", typename VectorOf<F>::Type{}, any);
    else if constexpr (Described<F>)
      bind_definition<F>(module_);
  }

 private:
  py::module_& module_;
};

// Makes the class, and those of its parts, unless they are there.
template <class T>
void bind_definition(py::module_& m) {
  const std::string type = name_of_type<T>();
  const char* const name = type.c_str();
  if (py::hasattr(m, name)) return;
  PartBinder parts(m);
  const T defaults{};
  describe(parts, defaults);
  const std::string path = std::is_constructible_v<JointDef, T> ? lower_case(name) + "." : "";
  py::class_<T> c(m, name, text_of(name, "").c_str());
  c.def(py::init([path](const py::kwargs& values) { return from_keywords<T>(values, path); }));
  const py::list fields = fields_of<T>(name);
  c.attr("_fields") = py::tuple(fields);
  for (const py::handle entry : fields) {
    const auto field = entry.cast<py::tuple>()[0].cast<std::string>();
    c.def_property(
        field.c_str(),
        [field](py::object self) {
          FieldGetter getter(field, self);
          describe(getter, self.cast<T&>());
          return getter.value;
        },
        [field, path](T& self, const py::object& value) {
          FieldSetter<T> setter(field, value, path);
          describe(setter, self);
        },
        text_of(name, field).c_str());
  }
  c.def(
      "replace",
      [path](const T& self, const py::kwargs& values) {
        T copy = self;
        set_fields(copy, values, path);
        return copy;
      },
      "A copy with other values in the named fields.");
  c.def("__copy__", [](const T& self) { return self; });
  c.def("__deepcopy__", [](const T& self, const py::dict&) { return self; });
  c.def("__repr__", [name = std::string(name)](T& self) { return repr_of(name, self); });
  c.def(
      "__eq__", [](const T& a, const T& b) { return FieldComparer::same(a, b); }, py::is_operator());
}

// An argument that is a definition, or a dict of its fields.
template <class T>
struct OrFields {
  T value{};
};

}

namespace pybind11::detail {

template <class T>
struct type_caster<sudar::python::OrFields<T>> {
  using OrFields = sudar::python::OrFields<T>;
  PYBIND11_TYPE_CASTER(OrFields, const_name("Union[") + make_caster<T>::name + const_name(", Dict[str, Any]]"));
  bool load(handle source, bool) {
    if (!isinstance<T>(source) && !isinstance<dict>(source)) return false;
    value.value = sudar::python::read_field<T>(source, "");
    return true;
  }
};

}
