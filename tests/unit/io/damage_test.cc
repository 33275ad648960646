// Damaged files are refused or read, and nothing else: cut anywhere, and with bytes of every kind in every place.
#include "unit/io/files.h"

namespace sudar_test {
namespace {

class Damage : public Files {
 protected:
  void try_all(const std::string& name, const std::string& whole, std::size_t tries) {
    const io::ReadOptions options{
        .limits = {.bytes = 1 << 20, .nesting = 32, .items = 1000, .vertices = 10'000, .findings = 20}};
    std::uint64_t random = 1;  // D. Knuth's congruential generator: the same damage everywhere
    const auto next = [&](std::size_t below) {
      random = random * 6364136223846793005u + 1442695040888963407u;
      return std::size_t(random >> 33) % below;
    };
    std::size_t read_ones = 0;
    for (std::size_t i = 0; i < tries; ++i) {
      std::string damaged = whole;
      if (i % 3 == 0) damaged.resize(next(whole.size()));
      for (std::size_t k = 0; k < 1 + i % 4 && !damaged.empty(); ++k) {
        static constexpr char bytes[] = {'\0', '\xff', '\x7f', '-', '9', '0', '"', ']', '}', ',', 'e', ' '};
        damaged[next(damaged.size())] = i % 2 == 0 ? bytes[next(sizeof bytes)] : char(next(256));
      }
      const io::Reading r = read(name, damaged, options);
      ASSERT_TRUE(r.made || !r.findings.empty());
      if (!r.made) continue;
      ++read_ones;
      World w(r.model().config);
      io::build(r.model(), w);
    }
    EXPECT_GT(read_ones, 0u);  // else the damage was too much to test anything
    EXPECT_LT(read_ones, tries);
  }
};

TEST_F(Damage, Gltf) {
  io::Model m;
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  m.bodies.push_back({BodyDef{.shape = box({1, 1, 1}), .name = "a"}, {}, ""});
  m.bodies.push_back({BodyDef{.shape = hull(corners),
                              .at = {3, 0, 0},
                              .mass = 2,
                              .inertia = Mat3::diagonal({1, 1, 1}),
                              .filter = {.category = 2}},
                      {},
                      ""});
  m.joints.push_back({Hinge{.a = io::body_number(0),
                             .b = io::body_number(1),
                             .at = {1, 0, 0},
                             .limit = {-1, 1},
                             .drive = {.mode = DriveMode::spring, .force = 1, .stiffness = 1}},
                       {},
                       "",
                      {}});
  std::vector<io::Finding> lost;
  for (const char* name : {"a.gltf", "a.glb"}) {
    const Bytes bytes = io::write(m, name, lost);
    try_all(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}, 600);
  }
}

TEST_F(Damage, Meshes) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 4\nproperty list uchar int vertex_index\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
  try_all("a.ply", ply, 400);
  try_all("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n", 400);
  std::string stl = "solid a\n";
  for (const char* face :
       {"vertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\n", "vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\n"}) {
    stl += std::string("facet normal 0 0 0\nouter loop\n") + face + "endloop\nendfacet\n";
  }
  try_all("a.stl", stl, 400);
}

}
}
