// Config got a bool that fitted into its padding. A plugin built before had the same sizes and was accepted; what it
// set one_point_contact to arrived as exact_joints. Now a plugin also tells where the fields lie.
#include <sudar/layout.h>

#include "unit/worlds.h"

namespace sudar_test {
namespace {

struct Inner {
  Real length = 0;
  bool first = false, second = false;
};
struct InnerWithMore {
  Real length = 0;
  bool added = false, first = false, second = false;
};
template <class V, Like<Inner> T>
void describe(V& v, T& d) {
  v("length", d.length, any), v("first", d.first, any), v("second", d.second, any);
}
template <class V, Like<InnerWithMore> T>
void describe(V& v, T& d) {
  v("length", d.length, any), v("added", d.added, any), v("first", d.first, any), v("second", d.second, any);
}
template <class Part>
struct Outer {
  int count = 0;
  Part part{};
};
template <class V, class Part>
void describe(V& v, const Outer<Part>& d) {
  v("count", d.count, any), v("part", d.part, any);
}

TEST(PluginLayout, TellsWhatSizesDoNot) {
  static_assert(sizeof(Inner) == sizeof(InnerWithMore));
  EXPECT_EQ(Layout::of<Inner>(), Layout::of<Inner>());
  EXPECT_NE(Layout::of<Inner>(), Layout::of<InnerWithMore>());
  EXPECT_NE(Layout::of<Outer<Inner>>(), Layout::of<Outer<InnerWithMore>>());
}

TEST(PluginLayout, OfEveryAlternative) {
  EXPECT_NE(Layout::of(std::variant<Bar, Rope>{}), Layout::of(std::variant<Bar, Ball>{}));
}

}
}
