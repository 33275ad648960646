#include "collision/broad/box_tree.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION {

namespace {

Box join(const Box& a, const Box& b) {
  return {{min(a.low.x, b.low.x), min(a.low.y, b.low.y), min(a.low.z, b.low.z)},
          {max(a.high.x, b.high.x), max(a.high.y, b.high.y), max(a.high.z, b.high.z)}};
}

// Half the surface area, which is all that comparisons need. May overflow to infinity: that costs quality only.
double area(const Box& b) {
  const double x = b.high.x - b.low.x, y = b.high.y - b.low.y, z = b.high.z - b.low.z;
  return x * y + y * z + z * x;
}

double center(const Box& b, int axis) { return 0.5 * b.low[axis] + 0.5 * b.high[axis]; }

std::uint32_t ceil_log2(std::size_t n) {
  std::uint32_t k = 0;
  while ((std::size_t(1) << k) < n) ++k;
  return k;
}

}

// --- changes ---

std::uint32_t BoxTree::add(const Box& box, std::uint32_t id) {
  const std::uint32_t leaf = take();
  nodes_[leaf] = {box, none, id, none, 0};
  pending_.push_back(leaf);
  ++leaves_;
  return leaf;
}

void BoxTree::move(std::uint32_t leaf, const Box& box) {
  Node& node = nodes_[leaf];
  node.box = box;
  if (node.parent == none || !contains(nodes_[node.parent].box, box)) pending_.push_back(leaf);
}

void BoxTree::remove(std::uint32_t leaf) {
  unlink(leaf);
  give_back(leaf);
  --leaves_;
}

void BoxTree::settle() {
  inserted_ += pending_.size();
  if (pending_.size() > leaves_ / 2 || inserted_ > 4 * leaves_) {
    rebuild();
  } else {
    for (const std::uint32_t leaf : pending_) unlink(leaf);
    for (const std::uint32_t leaf : pending_) link(leaf);
    if (height() > height_limit()) rebuild();
  }
  pending_.clear();
}

std::uint32_t BoxTree::height_limit() const { return 3 * ceil_log2(leaves_) + 4; }

// --- nodes ---

std::uint32_t BoxTree::take() {
  if (free_.empty()) {
    nodes_.emplace_back();
    return std::uint32_t(nodes_.size() - 1);
  }
  const std::uint32_t node = free_.back();
  free_.pop_back();
  return node;
}

void BoxTree::give_back(std::uint32_t node) {
  nodes_[node] = {};
  free_.push_back(node);
}

void BoxTree::adopt(std::uint32_t node, std::uint32_t left, std::uint32_t right) {
  nodes_[node].left = left, nodes_[node].right = right;
  nodes_[left].parent = nodes_[right].parent = node;
  refit(node);
}

// Whether that changed the node.
bool BoxTree::refit(std::uint32_t node) {
  Node& n = nodes_[node];
  const Node &left = nodes_[n.left], &right = nodes_[n.right];
  const Box box = join(left.box, right.box);
  const std::uint32_t height = 1 + max(left.height, right.height);
  if (box.low == n.box.low && box.high == n.box.high && height == n.height) return false;
  n.box = box, n.height = height;
  return true;
}

void BoxTree::refit_from(std::uint32_t node) {
  while (node != none && refit(node)) node = nodes_[node].parent;
}

void BoxTree::replace(std::uint32_t parent, std::uint32_t child, std::uint32_t by) {
  if (parent == none)
    root_ = by;
  else
    (nodes_[parent].left == child ? nodes_[parent].left : nodes_[parent].right) = by;
  if (by != none) nodes_[by].parent = parent;
}

// --- insertion and removal ---

void BoxTree::unlink(std::uint32_t leaf) {
  const std::uint32_t parent = nodes_[leaf].parent;
  nodes_[leaf].parent = none;
  if (parent == none) {
    if (root_ == leaf) root_ = none;
    return;
  }
  const std::uint32_t sibling = nodes_[parent].left == leaf ? nodes_[parent].right : nodes_[parent].left;
  const std::uint32_t grandparent = nodes_[parent].parent;
  replace(grandparent, parent, sibling);
  give_back(parent);
  refit_from(grandparent);
}

void BoxTree::link(std::uint32_t leaf) {
  if (root_ == none) {
    root_ = leaf;
    return;
  }
  const std::uint32_t sibling = best_sibling(nodes_[leaf].box), above = nodes_[sibling].parent;
  const std::uint32_t parent = take();
  replace(above, sibling, parent);
  adopt(parent, sibling, leaf);
  refit_from(above);
}

// Descends into the child whose subtree would grow less, until a parent for the node at hand and the new leaf costs
// less than any place further down. Among equal children the lower one, so that coincident boxes make no chain.
std::uint32_t BoxTree::best_sibling(const Box& box) const {
  std::uint32_t n = root_;
  while (!nodes_[n].is_leaf()) {
    const double joined = area(join(nodes_[n].box, box)), growth = joined - area(nodes_[n].box);
    const auto cost = [&](std::uint32_t child) {
      const double with = area(join(nodes_[child].box, box));
      return growth + (nodes_[child].is_leaf() ? with : with - area(nodes_[child].box));
    };
    const std::uint32_t left = nodes_[n].left, right = nodes_[n].right;
    const double cost_left = cost(left), cost_right = cost(right);
    if (joined < min(cost_left, cost_right)) break;
    const bool equal = !(cost_left < cost_right) && !(cost_right < cost_left);
    n = (equal ? nodes_[left].height < nodes_[right].height : cost_left < cost_right) ? left : right;
  }
  return n;
}

// --- building ---

void BoxTree::rebuild() {
  std::vector<std::uint32_t> leaves;
  leaves.reserve(leaves_);
  free_.clear();
  for (std::uint32_t n = std::uint32_t(nodes_.size()); n-- > 0;) {
    if (nodes_[n].is_used() && nodes_[n].is_leaf())
      leaves.push_back(n);
    else
      give_back(n);
  }
  inserted_ = 0;
  root_ = none;
  if (leaves.empty()) return;
  root_ = build(leaves, 2 * ceil_log2(leaves.size()) + 2);
  nodes_[root_].parent = none;
}

// A tree of the leaves, none of them more than `levels` below its root.
std::uint32_t BoxTree::build(std::span<std::uint32_t> leaves, std::uint32_t levels) {
  if (leaves.size() == 1) return leaves[0];
  const std::size_t half = split(leaves, levels - 1);
  const std::uint32_t node = take();
  const std::uint32_t left = build(leaves.first(half), levels - 1), right = build(leaves.subspan(half), levels - 1);
  adopt(node, left, right);
  return node;
}

// Orders the leaves so that the first ones, whose number it returns, become one child and the rest the other, each of
// at most `levels` levels. Leaves are sorted into bins by the centres of their boxes along the axis on which these
// spread most; the split between bins with the smallest sum of area × leaves wins. Order within the halves means
// nothing.
std::size_t BoxTree::split(std::span<std::uint32_t> leaves, std::uint32_t levels) const {
  constexpr std::size_t bins = 16;
  const std::size_t n = leaves.size(), most = levels < 32 ? std::size_t(1) << levels : n;
  Pos low = nodes_[leaves[0]].box.low, high = low;
  for (int k = 0; k < 3; ++k) low[k] = high[k] = center(nodes_[leaves[0]].box, k);
  for (const std::uint32_t leaf : leaves) {
    for (int k = 0; k < 3; ++k) {
      const double c = center(nodes_[leaf].box, k);
      low[k] = min(low[k], c), high[k] = max(high[k], c);
    }
  }
  int axis = 0;
  for (int k = 1; k < 3; ++k) {
    if (high[k] - low[k] > high[axis] - low[axis]) axis = k;
  }
  const double bins_per_length = bins / (high[axis] - low[axis]);
  const auto bin_of = [&](std::uint32_t leaf) {
    const double b = (center(nodes_[leaf].box, axis) - low[axis]) * bins_per_length;
    return b >= 0 ? std::size_t(min(b, double(bins - 1))) : 0;
  };

  std::array<Box, bins> box;
  std::array<std::size_t, bins> count{};
  for (const std::uint32_t leaf : leaves) {
    const std::size_t b = bin_of(leaf);
    box[b] = count[b]++ == 0 ? nodes_[leaf].box : join(box[b], nodes_[leaf].box);
  }
  // Cost of the bins up to and including b, then of those after it.
  std::array<double, bins> cost{};
  std::array<std::size_t, bins> before{};
  const auto add_costs = [&](std::size_t first, std::size_t last, int step, auto add) {
    Box all{};
    std::size_t sum = 0;
    for (std::size_t b = first; b != last; b += std::size_t(step)) {
      if (count[b] > 0) all = sum == 0 ? box[b] : join(all, box[b]), sum += count[b];
      add(b, sum, sum == 0 ? 0 : area(all) * double(sum));
    }
  };
  add_costs(0, bins, 1, [&](std::size_t b, std::size_t sum, double c) { before[b] = sum, cost[b] += c; });
  add_costs(bins - 1, 0, -1, [&](std::size_t b, std::size_t, double c) { cost[b - 1] += c; });
  std::size_t best = bins;
  for (std::size_t b = 0; b + 1 < bins; ++b) {
    const bool fits = before[b] > 0 && before[b] < n && before[b] <= most && n - before[b] <= most;
    if (fits && (best == bins || cost[b] < cost[best])) best = b;
  }
  if (best < bins) {
    std::partition(leaves.begin(), leaves.end(), [&](std::uint32_t leaf) { return bin_of(leaf) <= best; });
    return before[best];
  }
  const auto middle = leaves.begin() + std::ptrdiff_t(n / 2);
  std::nth_element(leaves.begin(), middle, leaves.end(), [&](std::uint32_t a, std::uint32_t b) {
    const double x = center(nodes_[a].box, axis), y = center(nodes_[b].box, axis);
    return x < y || (x == y && a < b);
  });
  return n / 2;
}

// --- looking ---

void BoxTree::inner_boxes(std::vector<Box>& out) const {
  for (const Node& node : nodes_) {
    if (node.is_used() && !node.is_leaf()) out.push_back(node.box);
  }
}

}
