// OBJ, STL and PLY become bodies.
#include "unit/io/files.h"

#include <cstring>

namespace sudar_test {
namespace {

class MeshFiles : public Files {};

const char* const cube_obj = R"(# a box of 1 × 2 × 3
v 0 0 0
v 1 0 0
v 1 2 0
v 0 2 0
v 0 0 3
v 1 0 3
v 1 2 3
v 0 2 3
vn 0 0 1
f 4//1 3//1 2//1 1//1
f 5 6 7 8
f 1 2 6 5
f 3 4 8 7
f -7 -6 -2 -3
f 1 5 8 4
)";

TEST_F(MeshFiles, AClosedOneFallsWithItsMass) {
  const io::Reading r = read("box.obj", cube_obj);
  ASSERT_TRUE(r.made) << text_of(r);
  EXPECT_EQ(text_of(r), "");
  World w;
  const Body b = io::build(r.model(), w).bodies.at(0);
  EXPECT_NEAR(w[b].mass(), 6000, 1e-2);
  expect_near(w[b].center(), Vec3d{0.5, 1, 1.5}, 1e-6);
  EXPECT_NEAR(w[b].inertia().c0.x, 500 * (4 + 9), 1e-1);
  EXPECT_EQ(w[b].motion(), Motion::dynamic);
}

TEST_F(MeshFiles, AnOpenOneStandsInTheWay) {
  const io::Reading r = read("quad.obj", "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nf 1 2 3 4\n");
  ASSERT_TRUE(r.made) << text_of(r);
  EXPECT_EQ(r.model().bodies.at(0).def.motion, Motion::fixed);
  EXPECT_EQ(r.model().bodies.at(0).def.shape.kind(), ShapeKind::mesh);
}

TEST_F(MeshFiles, ErrorsNameTheLine) {
  EXPECT_TRUE(says(read("a.obj", "v 0 0 0\nv 1 0\n"), "a.obj:2: error: a vertex needs three numbers"));
  EXPECT_TRUE(says(read("a.obj", "v 0 0 0\nf 1 2 3\n"), "a.obj:2: error: names vertex 2, but there are 1 so far"));
  EXPECT_TRUE(says(read("a.obj", "v 0 0 nan\n"), "a.obj:1: error: \"nan\" given"));
  EXPECT_TRUE(says(read("a.obj", ""), "has no triangles"));
  EXPECT_TRUE(says(read("a.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 1 2 3\nendloop\n"),
                   "a.stl:5: error: a triangle has 1 corners"));
  EXPECT_TRUE(says(read("a.ply", "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n"),
                   "a.ply:6: error: is cut short"));
  EXPECT_TRUE(says(read("a.step", ""), "the name does not end with one of"));
  EXPECT_TRUE(says(io::read(folder / "none.stl"), "there is no such file"));
}

std::string stl_of_box(float scale) {
  const int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                            {2, 3, 7}, {2, 7, 6}, {1, 2, 6}, {1, 6, 5}, {0, 4, 7}, {0, 7, 3}};
  const float corners[8][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  std::string bytes = "solid, but binary" + std::string(63, ' ');
  const auto put = [&](const auto& x) { bytes.append(reinterpret_cast<const char*>(&x), sizeof x); };
  put(std::uint32_t(12));
  for (const auto& face : faces) {
    bytes.append(12, '\0');
    for (const int corner : face) {
      for (const float x : corners[corner]) put(x * scale);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

// In millimetres a cube of 20 mm is 20 m large; the unit says that it is not.
TEST_F(MeshFiles, AsksForTheUnit) {
  const io::Reading asked = read("cube.stl", stl_of_box(20));
  ASSERT_TRUE(asked.made) << text_of(asked);
  EXPECT_TRUE(says(asked, "warning: is 20 m large")) << text_of(asked);
  EXPECT_TRUE(says(asked, "--unit mm"));
  const io::Reading told = read("cube.stl", stl_of_box(20), {.unit = 0.001});
  ASSERT_TRUE(told.made);
  EXPECT_EQ(text_of(told), "");
  World w;
  const Body b = io::build(told.model(), w).bodies.at(0);
  EXPECT_NEAR(w[b].mass(), 0.008, 1e-7);
}

TEST_F(MeshFiles, PlyOfEitherOrder) {
  const std::string head =
      "ply\nformat binary_big_endian 1.0\ncomment x\nelement vertex 3\nproperty float x\nproperty float y\n"
      "property uchar red\nproperty double z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  std::string body;
  const auto put = [&](auto x) {
    std::array<char, sizeof x> raw;
    std::memcpy(raw.data(), &x, sizeof x);
    body.append(raw.rbegin(), raw.rend());
  };
  for (const auto& [x, y, z] : {std::array{0.f, 0.f, 0.f}, {1.f, 0.f, 0.f}, {0.f, 0.f, -1.f}}) {
    put(x), put(y), put(std::uint8_t(7)), put(double(z));
  }
  put(std::uint8_t(3)), put(0), put(1), put(2);
  const io::Reading r = read("a.ply", head + body);
  ASSERT_TRUE(r.made) << text_of(r);
  const Shape& shape = r.model().bodies.at(0).def.shape;
  ASSERT_EQ(shape.vertices().size(), 3u);
  EXPECT_EQ(shape.faces().size(), 1u);
  EXPECT_TRUE(says(read("b.ply", head + body.substr(0, body.size() - 1)), "is cut short"));
}

}
}
