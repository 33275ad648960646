// Joints that hang together as one linear system K λ = r with K = J M⁻¹ Jᵀ: a block of up to six rows a joint, joints
// coupled by the bodies they share. Factored L D Lᵀ; joints are eliminated by least degree first, so that chains and
// trees fill in nothing and cost as much as they have joints (George, Liu 1981).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "dynamics/rows.h"

namespace sudar::inline SUDAR_PRECISION {

class JointSystem {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffu;
  struct Joint {
    std::uint32_t a, b;  // bodies that answer impulses; nobody: the world, a fixed or a kinematic body
    int rows;            // 0…6; none: a rope, a muscle
    bool operator==(const Joint&) const = default;
  };

  // Decides order and fill from who shares a body with whom; nothing where factoring would take more than about `most`
  // multiplications. Numbers of joints in what follows are those of the list.
  static std::optional<JointSystem> plan(std::span<const Joint> joints, std::int64_t most);
  std::size_t size() const { return joints_.size(); }
  const Joint& joint(std::size_t k) const { return joints_[k]; }
  bool loops() const { return loops_; }  // the world counts as a body

  // rows[k]: the rows of joint k. A relative compliance (diagonal · (1 + c)) keeps rows that repeat each other
  // solvable; closed loops of hinges repeat themselves.
  void factor(std::span<const std::span<const PreparedRow>> rows);
  // r → λ in place; entry k is that of joint k.
  void solve(std::span<std::array<Real, 6>> r) const;

 private:
  struct Block {  // couples joint `row` to the joint of the column, which was eliminated before
    std::uint32_t row;
    std::uint32_t at;  // first of its numbers, row by row
  };
  struct Column {
    std::uint32_t joint, diagonal;
    std::vector<Block> below;            // in the order of their own elimination
    std::vector<std::uint32_t> targets;  // block that below[i] and below[j], j ≤ i, change: i outside, j inside
  };
  struct Coupling {  // of two joints by a body that both act on
    std::uint32_t row, column, at;
    bool row_b, column_b;  // on which side they have it
  };

  bool eliminate(std::int64_t most);
  void fill(std::span<const std::span<const PreparedRow>> rows);

  std::vector<Joint> joints_;
  std::vector<Column> columns_;  // in the order of elimination
  std::vector<Coupling> couplings_;
  std::vector<Real> numbers_;
  bool loops_ = false;
};

}
