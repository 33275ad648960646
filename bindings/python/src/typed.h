// As<"List[Body]">: a Python object whose type is written so in signatures, and from there in the stubs.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>

namespace sudar::python {

template <std::size_t n>
struct TypeText {
  char value[n]{};
  constexpr TypeText(const char (&text)[n]) { std::copy_n(text, n, value); }
};
template <TypeText>
struct As : pybind11::object {
  As() = default;
  As(pybind11::object o) : pybind11::object(std::move(o)) {}
  As(pybind11::handle h, borrowed_t how) : pybind11::object(h, how) {}
  As(pybind11::handle h, stolen_t how) : pybind11::object(h, how) {}
  static bool check_(pybind11::handle) { return true; }  // as an argument it takes anything
};

}

namespace pybind11::detail {

template <sudar::python::TypeText text>
struct handle_type_name<sudar::python::As<text>> {
  static constexpr auto name = const_name(text.value);
};

}
