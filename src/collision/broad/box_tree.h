// A dynamic hierarchy of bounding boxes: each inner node's box encloses its two children's, the leaves' boxes are the
// user's. Add, move and remove leaves, then settle(), then search.
//
// Shape. What a search visits is, on average, proportional to the surface area of the inner nodes (Goldsmith & Salmon
// 1987, "Automatic creation of object hierarchies for ray tracing"), so area is what every decision minimises:
// - few leaves new or moved: each descends from the root to where it adds the least area, O(log n);
// - a moved leaf that its parent's box still encloses stays where it is, O(1): small motions cost nothing;
// - most leaves new or moved, or as many insertions since the last time as there are leaves: everything is built anew
//   from above, splitting where binned areas are smallest (Wald 2007, "On fast construction of SAH-based bounding
//   volume hierarchies"), O(n log n). So the loss of quality by insertions is paid back at a constant cost per
//   insertion.
// Area alone bounds no depth: a tree higher than 3 log₂ n + 4 is built anew too, and a builder that runs out of levels
// splits in halves. The bound is hard, so a search needs no more memory than a small array.
//
// Rejected: rotations on the way up (building anew restores more than they do); AVL balance (paid for with area); boxes
// in float (positions are double, far from the origin they must stay exact).
#pragma once

#include "collision/broad/broad.h"

namespace sudar::inline SUDAR_PRECISION {

class BoxTree {
 public:
  static constexpr std::uint32_t none = 0xffffffffu;

  // Between two calls of settle() a leaf is added, moved or removed at most once, and nothing is searched.
  std::uint32_t add(const Box&, std::uint32_t id);  // the new leaf's number; numbers are used again
  void move(std::uint32_t leaf, const Box&);
  void remove(std::uint32_t leaf);
  void settle();

  // Calls visit(id) for every leaf whose box overlaps `box`.
  template <class Visit>
  void search(const Box& box, Visit visit) const {
    if (root_ == none) return;
    std::uint32_t stack[max_levels], top = 0;
    stack[top++] = root_;
    while (top > 0) {
      const Node& node = nodes_[stack[--top]];
      if (!overlap(node.box, box)) continue;
      if (node.is_leaf())
        visit(node.id());
      else
        stack[top++] = node.left, stack[top++] = node.right;
    }
  }

  // Calls visit(id) for every leaf whose box the ray meets, the nearer half of each node first; visit may shorten
  // ray.reach.
  template <class Visit>
  void cast(BoxRay& ray, Visit visit) const {
    if (root_ == none) return;
    struct Waiting {
      std::uint32_t node;
      double at;
    };
    Waiting stack[max_levels];
    std::uint32_t top = 0;
    stack[top++] = {root_, ray.enters(nodes_[root_].box)};
    while (top > 0) {
      const Waiting next = stack[--top];
      if (!(next.at <= ray.reach)) continue;
      const Node& node = nodes_[next.node];
      if (node.is_leaf()) {
        visit(node.id());
        continue;
      }
      const Waiting left{node.left, ray.enters(nodes_[node.left].box)};
      const Waiting right{node.right, ray.enters(nodes_[node.right].box)};
      const bool left_first = left.at <= right.at;
      stack[top++] = left_first ? right : left;
      stack[top++] = left_first ? left : right;
    }
  }

  std::size_t size() const { return leaves_; }
  std::uint32_t height() const { return root_ == none ? 0 : nodes_[root_].height; }  // of a single leaf: 0
  std::uint32_t height_limit() const;                                                // never exceeded after settle()
  void inner_boxes(std::vector<Box>& out) const;

 private:
  static constexpr std::uint32_t max_levels = 128;  // above 3 · 32 + 4

  struct Node {  // 64 bytes: a cache line
    Box box;
    std::uint32_t parent = none;
    std::uint32_t left = none, right = none;  // of a leaf: its id, none; of an unused node: none, none
    std::uint32_t height = 0;                 // above the deepest leaf below it

    bool is_leaf() const { return right == none; }
    bool is_used() const { return left != none; }
    std::uint32_t id() const { return left; }
  };

  std::uint32_t take();
  void give_back(std::uint32_t node);
  void adopt(std::uint32_t node, std::uint32_t left, std::uint32_t right);
  bool refit(std::uint32_t node);
  void refit_from(std::uint32_t node);
  void replace(std::uint32_t parent, std::uint32_t child, std::uint32_t by);
  void link(std::uint32_t leaf);
  void unlink(std::uint32_t leaf);
  std::uint32_t best_sibling(const Box&) const;
  void rebuild();
  std::uint32_t build(std::span<std::uint32_t> leaves, std::uint32_t levels);
  std::size_t split(std::span<std::uint32_t> leaves, std::uint32_t levels) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> free_, pending_;  // pending: new or moved leaves
  std::uint32_t root_ = none;
  std::size_t leaves_ = 0, inserted_ = 0;  // inserted: since the whole was built
};

}
