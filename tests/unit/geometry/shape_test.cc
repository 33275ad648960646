#include "geometry/geometry.h"
#include <gtest/gtest.h>
using namespace sudar;
TEST(Shape, Smoke) {
  for (auto s : {box({1, 2, 3}), prism(24, 6, 6), pyramid(12, 40, 10), uv_sphere(1), uv_sphere(1,100,50), tetrahedron(1), octahedron(1), dodecahedron(1), icosahedron(1), truncated_icosahedron(2), wedge({200, 30, 100}), cylinder(1, 2), cone(1, 2), sphere(1), capsule(1, 2)}) {
    auto m = s.mass_properties();
    std::printf("V %g F %zu v %zu c %g %g %g I %g %g %g\n", m.volume, s.faces().size(), s.vertices().size(), m.center.x, m.center.y, m.center.z, m.inertia.c0.x, m.inertia.c1.y, m.inertia.c2.z);
  }
}
