#include "dynamics/joint_system.h"

#include <algorithm>
#include <set>
#include <utility>

#include "dynamics/small_system.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

// Measured in float (a four-bar linkage of hinges repeats rows: with less it locks).
Real compliance(bool loops) {
  if constexpr (sizeof(Real) == 4)
    return loops ? Real(1e-4) : Real(1e-6);
  else
    return loops ? Real(1e-8) : Real(1e-12);
}

// What holds the world and what goes round: more joints than a tree over these bodies has.
bool has_loops(std::span<const JointSystem::Joint> joints) {
  std::vector<std::uint32_t> bodies;
  bool grounded = false;
  std::ptrdiff_t count = 0;
  for (const JointSystem::Joint& j : joints) {
    if (j.rows == 0) continue;
    ++count;
    for (const std::uint32_t body : {j.a, j.b}) {
      if (body == JointSystem::nobody)
        grounded = true;
      else
        bodies.push_back(body);
    }
  }
  std::sort(bodies.begin(), bodies.end());
  const auto distinct = std::unique(bodies.begin(), bodies.end()) - bodies.begin();
  return count > distinct - (grounded ? 0 : 1);
}

}

std::optional<JointSystem> JointSystem::plan(std::span<const Joint> joints, std::int64_t most) {
  JointSystem system;
  system.joints_.assign(joints.begin(), joints.end());
  system.loops_ = has_loops(joints);
  struct Side {
    std::uint32_t body, joint;
    bool b;
  };
  std::vector<Side> sides;
  for (std::uint32_t k = 0; k < joints.size(); ++k) {
    if (joints[k].a != nobody) sides.push_back({joints[k].a, k, false});
    if (joints[k].b != nobody) sides.push_back({joints[k].b, k, true});
  }
  std::stable_sort(sides.begin(), sides.end(), [](const Side& p, const Side& q) { return p.body < q.body; });
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (std::int64_t(system.couplings_.size()) > most) return {};  // many joints on one body
    for (std::size_t j = i + 1; j < sides.size() && sides[j].body == sides[i].body; ++j) {
      if (sides[i].joint == sides[j].joint) continue;
      system.couplings_.push_back({sides[i].joint, sides[j].joint, 0, sides[i].b, sides[j].b});
    }
  }
  if (!system.eliminate(most)) return {};
  return system;
}

bool JointSystem::eliminate(std::int64_t most) {
  const auto n = std::uint32_t(joints_.size());
  std::vector<std::vector<std::uint32_t>> near(n);  // neighbours that are not eliminated yet, ascending
  const auto tidy = [](std::vector<std::uint32_t>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  };
  for (const Coupling& c : couplings_) near[c.row].push_back(c.column), near[c.column].push_back(c.row);
  std::vector<std::int64_t> degree(n);  // in rows
  const auto settle = [&](std::uint32_t k) {
    tidy(near[k]);
    degree[k] = 0;
    for (const std::uint32_t other : near[k]) degree[k] += joints_[other].rows;
  };
  std::set<std::pair<std::int64_t, std::uint32_t>> waiting;  // by degree
  const auto again = [&](std::uint32_t k) {
    waiting.erase({degree[k], k});
    settle(k);
    waiting.insert({degree[k], k});
  };
  for (std::uint32_t k = 0; k < n; ++k) again(k);

  std::uint32_t numbers = 0;
  const auto room = [&](std::uint32_t row, std::uint32_t column) {
    return std::exchange(numbers, numbers + std::uint32_t(joints_[row].rows * joints_[column].rows));
  };
  std::vector<std::uint32_t> turn(n, n);  // when a joint was eliminated
  std::int64_t cost = 0;
  for (std::uint32_t step = 0; step < n; ++step) {
    const std::uint32_t next = waiting.begin()->second;
    waiting.erase(waiting.begin());
    turn[next] = step;
    const std::int64_t across = joints_[next].rows, down = degree[next];
    cost += across * (across * across / 3 + across * down + down * down / 2);
    if (cost > most) return false;
    Column column{next, room(next, next), {}, {}};
    const std::vector<std::uint32_t> left = std::move(near[next]);
    for (const std::uint32_t other : left) {
      column.below.push_back({other, room(other, next)});
      for (const std::uint32_t k : left) {
        if (k != other) near[other].push_back(k);
      }
      std::erase(near[other], next);
      again(other);
    }
    columns_.push_back(std::move(column));
  }
  numbers_.resize(numbers);

  // The block of a pair lies in the column of the one eliminated first.
  const auto place = [&](std::uint32_t later, std::uint32_t earlier) {
    const Column& column = columns_[turn[earlier]];
    if (later == earlier) return column.diagonal;
    return std::find_if(column.below.begin(), column.below.end(), [&](const Block& b) { return b.row == later; })->at;
  };
  for (Column& column : columns_) {
    std::sort(column.below.begin(), column.below.end(),
              [&](const Block& p, const Block& q) { return turn[p.row] < turn[q.row]; });
  }
  for (Column& column : columns_) {
    for (std::size_t i = 0; i < column.below.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) column.targets.push_back(place(column.below[i].row, column.below[j].row));
    }
  }
  for (Coupling& c : couplings_) {
    if (turn[c.row] < turn[c.column]) std::swap(c.row, c.column), std::swap(c.row_b, c.column_b);
    c.at = place(c.row, c.column);
  }
  return true;
}

// The matrix K itself; of the blocks on the diagonal the lower half.
void JointSystem::fill(std::span<const std::span<const PreparedRow>> rows) {
  std::fill(numbers_.begin(), numbers_.end(), Real(0));
  for (const Column& column : columns_) {
    const auto own = rows[column.joint];
    for (std::size_t i = 0; i < own.size(); ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        numbers_[column.diagonal + i * own.size() + j] = response(own[i], own[j]);
      }
    }
  }
  for (const Coupling& c : couplings_) {
    const auto down = rows[c.row], across = rows[c.column];
    for (std::size_t i = 0; i < down.size(); ++i) {
      const PreparedRow::Side& left = c.row_b ? down[i].b : down[i].a;
      for (std::size_t j = 0; j < across.size(); ++j) {
        numbers_[c.at + i * across.size() + j] += response(left, c.column_b ? across[j].b : across[j].a);
      }
    }
  }
}

// Below the diagonal the blocks hold W = A l⁻ᵀ = L d, so that A[i, j] −= W_i d⁻¹ W_jᵀ.
void JointSystem::factor(std::span<const std::span<const PreparedRow>> rows) {
  fill(rows);
  for (const Column& column : columns_) {
    const int across = joints_[column.joint].rows;
    Real* diagonal = numbers_.data() + column.diagonal;
    factor_small(diagonal, across, across, compliance(loops_));
    const std::uint32_t* target = column.targets.data();
    for (std::size_t i = 0; i < column.below.size(); ++i) {
      const Block& left = column.below[i];
      const int down = joints_[left.row].rows;
      Real* w = numbers_.data() + left.at;
      std::array<Real, 36> scaled;  // W d⁻¹
      for (int r = 0; r < down; ++r) {
        solve_lower(diagonal, across, across, w + r * across);
        for (int m = 0; m < across; ++m) scaled[std::size_t(r * 6 + m)] = w[r * across + m] * diagonal[m * across + m];
      }
      for (std::size_t j = 0; j <= i; ++j) {
        const Block& right = column.below[j];
        const int other = joints_[right.row].rows;
        const Real* v = numbers_.data() + right.at;
        Real* to = numbers_.data() + *target++;
        for (int r = 0; r < down; ++r) {
          for (int c = 0; c < other; ++c) {
            Real s = 0;
            for (int m = 0; m < across; ++m) s += scaled[std::size_t(r * 6 + m)] * v[c * across + m];
            to[r * other + c] -= s;
          }
        }
      }
    }
  }
}

void JointSystem::solve(std::span<std::array<Real, 6>> r) const {
  for (const Column& column : columns_) {
    const int across = joints_[column.joint].rows;
    const Real* diagonal = numbers_.data() + column.diagonal;
    Real* x = r[column.joint].data();
    solve_lower(diagonal, across, across, x);
    solve_diagonal(diagonal, across, across, x);
    for (const Block& block : column.below) {
      const Real* w = numbers_.data() + block.at;
      Real* y = r[block.row].data();
      for (int k = 0; k < joints_[block.row].rows; ++k) {
        for (int m = 0; m < across; ++m) y[k] -= w[k * across + m] * x[m];
      }
    }
  }
  for (std::size_t c = columns_.size(); c-- > 0;) {
    const Column& column = columns_[c];
    const int across = joints_[column.joint].rows;
    const Real* diagonal = numbers_.data() + column.diagonal;
    Real* x = r[column.joint].data();
    for (int m = 0; m < across; ++m) {
      Real s = 0;
      for (const Block& block : column.below) {
        const Real* w = numbers_.data() + block.at;
        const Real* y = r[block.row].data();
        for (int k = 0; k < joints_[block.row].rows; ++k) s += w[k * across + m] * y[k];
      }
      x[m] -= s * diagonal[m * across + m];
    }
    solve_upper(diagonal, across, across, x);
  }
}

}
