// Vectors, quaternions, matrices, enumerations and handles between C++ and Python. Python gives any sequence of numbers
// and gets numpy arrays of float64, in which a float has the same value; enumerations are their names.
#pragma once

#include <sudar/definitions.h>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "access.h"

namespace sudar::python {

// The three numbers, four numbers, or three columns of each type.
template <class T>
struct Numbers {};
template <class T>
struct Numbers<Vec3T<T>> {
  static constexpr int rows = 3, columns = 1;
  static T& at(Vec3T<T>& v, int i, int) { return v[i]; }
};
template <>
struct Numbers<Pos> {
  static constexpr int rows = 3, columns = 1;
  static double& at(Pos& p, int i, int) { return p[i]; }
};
template <class T>
struct Numbers<QuatT<T>> {
  static constexpr int rows = 4, columns = 1;
  static T& at(QuatT<T>& q, int i, int) { return i == 0 ? q.x : i == 1 ? q.y : i == 2 ? q.z : q.w; }
};
template <class T>
struct Numbers<Mat3T<T>> {
  static constexpr int rows = 3, columns = 3;
  static T& at(Mat3T<T>& m, int i, int j) { return m[j][i]; }
};
template <class T>
concept Numeric = requires {
  Numbers<T>::rows;
};

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;

// T from anything that numpy takes for numbers of its shape; false: it is something else.
template <Numeric T>
bool read_numbers(py::handle source, T& value) {
  using N = Numbers<T>;
  const Array array = Array::ensure(source);
  if (!array) return PyErr_Clear(), false;
  if (array.ndim() != (N::columns == 1 ? 1 : 2) || array.shape(0) != N::rows) return false;
  if (N::columns > 1 && array.shape(1) != N::columns) return false;
  for (int i = 0; i < N::rows; ++i) {
    for (int j = 0; j < N::columns; ++j) {
      auto& to = N::at(value, i, j);
      to = static_cast<std::remove_reference_t<decltype(to)>>(array.data()[i * N::columns + j]);
    }
  }
  return true;
}

template <Numeric T>
void write_numbers(T value, double* to) {
  using N = Numbers<T>;
  for (int i = 0; i < N::rows; ++i) {
    for (int j = 0; j < N::columns; ++j) *to++ = double(N::at(value, i, j));
  }
}

template <Numeric T>
py::array as_array(const T& value) {
  using N = Numbers<T>;
  Array array(N::columns == 1 ? std::vector<py::ssize_t>{N::rows} : std::vector<py::ssize_t>{N::rows, N::columns});
  write_numbers(value, array.mutable_data());
  // A copy: to write into it would change nothing else, so it is refused.
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

}

namespace pybind11::detail {

template <sudar::python::Numeric T>
struct type_caster<T> {
  using N = sudar::python::Numbers<T>;
  PYBIND11_TYPE_CASTER(T, const_name<N::columns == 3>(const_name("Matrix"),
                                                      const_name<N::rows == 4>(const_name("Quaternion"),
                                                                               const_name("Vector"))));
  bool load(handle source, bool) { return sudar::python::read_numbers(source, value); }
  static handle cast(const T& v, return_value_policy, handle) { return sudar::python::as_array(v).release(); }
};

template <class T>
concept Named = std::is_enum_v<T> && requires(T e) {
  { sudar::names(e) } -> std::same_as<const char* const*>;
};
template <Named T>
struct type_caster<T> {
  PYBIND11_TYPE_CASTER(T, const_name("str"));
  bool load(handle source, bool) {
    if (!isinstance<str>(source)) return false;
    const std::string wanted = source.cast<std::string>();
    for (int i = 0; sudar::names(T{})[i]; ++i) {
      if (wanted == sudar::names(T{})[i]) return value = T(i), true;
    }
    return false;
  }
  static handle cast(T e, return_value_policy, handle) { return str(sudar::names(e)[int(e)]).release(); }
};

// None is the null handle: the world, or nobody.
template <class Tag>
struct type_caster<sudar::Handle<Tag>> {
  using Bound = sudar::python::Bound<Tag>;
  PYBIND11_TYPE_CASTER(sudar::Handle<Tag>, const_name("Optional[") + make_caster<Bound>::name + const_name("]"));
  bool load(handle source, bool) {
    if (source.is_none()) return value = {}, true;
    if (!isinstance<Bound>(source)) return false;
    value = source.cast<const Bound&>().handle;
    return true;
  }
  static handle cast(const sudar::Handle<Tag>& h, return_value_policy, handle) {
    return h.null() ? none().release() : pybind11::cast(Bound{h, nullptr}).release();
  }
};

}
