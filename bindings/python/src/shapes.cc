#include "bind.h"
#include "definition.h"

namespace sudar::python {

namespace {

using namespace py::literals;
constexpr const char* kinds[] = {"sphere",    "capsule",       "half_space",      "hull", "cylinder", "cone",
                                 "ellipsoid", "hollow_sphere", "hollow_cylinder", "mesh"};
static_assert(std::size(kinds) == std::size_t(ShapeKind::mesh) + 1);

// Arguments by their names in shape.h, text from the comment beside it.
template <class F, class... Arguments>
void shape(py::module_& m, const char* name, F f, const Arguments&... arguments) {
  m.def(name, f, arguments..., text_of("Shape", name).c_str());
}

}

void bind_shapes(py::module_& m) {
  py::class_<Shape>(m, "Shape", "An immutable form in its own frame, m. Made by sphere(), box(), hull() and so on.")
      .def_property_readonly("kind", [](const Shape& s) { return kinds[int(s.kind())]; })
      .def_property_readonly("radius", &Shape::radius, "m; 0 of a half space, a hull, an ellipsoid")
      .def_property_readonly("half_length", &Shape::half_length,
                             "along y, m: half of a capsule's segment, half the height of a cylinder or cone; else 0")
      .def_property_readonly("radii", &Shape::radii, "of an ellipsoid, m; else 0")
      .def_property_readonly("bounding_radius", &Shape::bounding_radius,
                             "about the origin, m; infinite of a half space")
      .def_property_readonly(
          "mass_properties", [](const Shape& s) -> As<"MassProperties"> {
            const MassProperties p = s.mass_properties();
            return result<"MassProperties">(p.volume, p.center, p.inertia);
          })
      .def_property_readonly(
          "vertices",
          [](const Shape& s) {
            const auto points = s.vertices();
            Array array({py::ssize_t(points.size()), py::ssize_t(3)});
            for (std::size_t i = 0; i < points.size(); ++i) write_numbers(points[i], array.mutable_data() + 3 * i);
            return array;
          },
          "of a hull or mesh: (n, 3), m")
      .def_property_readonly("faces", &Shape::faces,
                             "of a hull or mesh: lists of numbers of vertices, counter-clockwise seen from outside")
      .def("__bool__", [](const Shape& s) { return bool(s); })
      .def(
          "__eq__", [](const Shape& a, const Shape& b) { return a == b; }, py::is_operator())
      .def("__repr__", [](const Shape& s) { return s ? std::string("<") + kinds[int(s.kind())] + ">" : "<no shape>"; });
  shape(m, "sphere", &sphere, "radius"_a);
  shape(m, "capsule", &capsule, "radius"_a, "length"_a);
  shape(m, "cylinder", py::overload_cast<Real, Real>(&cylinder), "radius"_a, "height"_a);
  shape(m, "cylinder", py::overload_cast<Real, Real, int>(&cylinder), "radius"_a, "height"_a, "sides"_a);
  shape(m, "cone", py::overload_cast<Real, Real>(&cone), "radius"_a, "height"_a);
  shape(m, "cone", py::overload_cast<Real, Real, int>(&cone), "radius"_a, "height"_a, "sides"_a);
  shape(m, "ellipsoid", &ellipsoid, "radii"_a);
  shape(m, "half_space", &half_space);
  shape(m, "hollow_sphere", &hollow_sphere, "radius"_a);
  shape(m, "hollow_cylinder", &hollow_cylinder, "radius"_a, "height"_a);
  shape(m, "box", &box, "edges"_a);
  shape(m, "prism", py::overload_cast<int, Real, Real>(&prism), "sides"_a, "radius"_a, "height"_a);
  shape(m, "pyramid", &pyramid, "sides"_a, "radius"_a, "height"_a);
  shape(m, "uv_sphere", &uv_sphere, "radius"_a, "slices"_a = 24, "stacks"_a = 12);
  shape(m, "tetrahedron", &tetrahedron, "edge"_a);
  shape(m, "octahedron", &octahedron, "edge"_a);
  shape(m, "dodecahedron", &dodecahedron, "edge"_a);
  shape(m, "icosahedron", &icosahedron, "edge"_a);
  shape(m, "truncated_icosahedron", &truncated_icosahedron, "edge"_a);
  shape(m, "wedge", &wedge, "edges"_a);
  shape(
      m, "hull", [](const std::vector<Vec3>& points) { return hull(points); }, "points"_a);
  shape(
      m, "mesh",
      [](const std::vector<Vec3>& vertices, const std::vector<std::vector<std::uint32_t>>& triangles) {
        std::vector<std::uint32_t> corners;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
          if (triangles[k].size() != 3) throw Error("triangles[" + std::to_string(k) + "]", "must name three vertices");
          corners.insert(corners.end(), triangles[k].begin(), triangles[k].end());
        }
        return mesh(vertices, corners);
      },
      "vertices"_a, "triangles"_a);
  shape(
      m, "extrude", [](const std::vector<Vec3>& outline, Real height) { return prism(outline, height); }, "outline"_a,
      "height"_a);
}

}
