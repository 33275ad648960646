// Cubes that fall on each other, each squarely on the one below, leaned over, up to 0.3 m in ten seconds: the passes
// visited the corners of a face one after the other and left more on the last, which turned every cube to the same
// side. Now all points of a face answer together first.
#include "unit/worlds.h"

using namespace sudar_test;

namespace {

TEST(LeaningTower, CubesThatFallSquarelyStayAboveEachOther) {
  for (const double gravity : {4.9, 5.0, 5.1}) {
    World w(steady());
    w.add(Gravity{{0, Real(-gravity), 0}});
    const Material m{Real(0.5), Real(0.5), 0};
    add_floor(w, 0, m);
    std::vector<Body> tower;
    for (int i = 0; i < 25; ++i)
      tower.push_back(w.add({.shape = box({4, 4, 4}), .at = {0, 2.1 + 4.1 * i, 0}, .density = 1, .material = m}));
    step(w, 300);
    for (const Body b : tower) {
      const Pos p = w[b].center();
      EXPECT_LT(sqrt(p.x * p.x + p.z * p.z), 0.05) << gravity;
    }
  }
}

}
