#include "collision/broad/box_tree.h"

#include "support.h"

#include <gtest/gtest.h>

namespace sudar::test {
namespace {

Box cube(double x, double y, double z, double half) {
  return {{x - half, y - half, z - half}, {x + half, y + half, z + half}};
}

std::size_t found(const BoxTree& tree, const Box& box) {
  std::size_t n = 0;
  tree.search(box, [&](std::uint32_t) { ++n; });
  return n;
}

// The inner nodes that searches for all leaves visit, per search.
double visits(const BoxTree& tree, const std::vector<Box>& leaves) {
  std::vector<Box> inner;
  tree.inner_boxes(inner);
  double n = 0;
  for (const Box& leaf : leaves) {
    for (const Box& box : inner) n += overlap(leaf, box);
  }
  return n / double(leaves.size());
}

// Coincident boxes, and boxes each of which encloses those before it, are what makes chains of the insertion by cost.
TEST(BoxTree, StaysShallow) {
  for (const double growth : {1.0, 1.01, 2.0}) {
    BoxTree tree;
    double half = 1;
    for (std::uint32_t i = 0; i < 1000; ++i) {
      tree.add(cube(0, 0, 0, half), i);
      tree.settle();
      ASSERT_LE(tree.height(), tree.height_limit());
      half *= growth;
    }
    EXPECT_EQ(found(tree, cube(0, 0, 0, 0.1)), 1000u);
  }
}

TEST(BoxTree, StaysShallowWhenLeavesGo) {
  BoxTree tree;
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 0; i < 1000; ++i) leaves.push_back(tree.add(cube(i * i, 0, 0, 1), i));
  tree.settle();
  Random random(1);
  while (leaves.size() > 1) {
    const auto k = std::size_t(random.below(int(leaves.size())));
    tree.remove(leaves[k]);
    leaves.erase(leaves.begin() + std::ptrdiff_t(k));
    tree.settle();
    ASSERT_LE(tree.height(), tree.height_limit());
  }
  EXPECT_EQ(tree.height(), 0u);
}

// Insertion one by one in the worst order, sorted, and long motion both leave a tree that is searched about as fast as
// one built at once: at most 1.3 times as many visits, where never building anew gives 1.5.
TEST(BoxTree, KeepsItsQuality) {
  std::vector<Box> boxes;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      for (int z = 0; z < 12; ++z) boxes.push_back(cube(x, y, z, 0.45));
    }
  }
  const auto built_at_once = [&] {
    BoxTree tree;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.add(boxes[i], i);
    tree.settle();
    return visits(tree, boxes);
  };
  BoxTree tree;
  std::vector<std::uint32_t> leaves;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    leaves.push_back(tree.add(boxes[i], i));
    tree.settle();
  }
  EXPECT_LT(visits(tree, boxes), 1.3 * built_at_once());

  Random random(2);
  for (int step = 0; step < 300; ++step) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (random.below(20) > 0) continue;
      const Vec3d way = wide(random.in_box(1));
      boxes[i] = {boxes[i].low + way, boxes[i].high + way};
      tree.move(leaves[i], boxes[i]);
    }
    tree.settle();
  }
  EXPECT_LT(visits(tree, boxes), 1.3 * built_at_once());
}

// A leaf that stays within its parent's box moves without a trace in the structure; searches see its new place.
TEST(BoxTree, SmallMotionsAreSeen) {
  BoxTree tree;
  const std::uint32_t leaf = tree.add(cube(0, 0, 0, 1), 0);
  tree.add(cube(3, 0, 0, 1), 1);
  tree.settle();
  tree.move(leaf, cube(0.5, 0, 0, 0.5));
  tree.settle();
  EXPECT_EQ(found(tree, cube(-0.5, 0, 0, 0.1)), 0u);
  EXPECT_EQ(found(tree, cube(0.5, 0, 0, 0.1)), 1u);
}

}
}
