#include "dynamics/soft_joints.h"

namespace sudar::inline SUDAR_PRECISION {

namespace {

class JointRowsOfBatch : public SoftBatch {
 public:
  explicit JointRowsOfBatch(const SoftBatch& batch) : SoftBatch(batch) {}

  void prepare(std::span<const std::uint32_t> islands) {
    w_.joints.clear(), w_.ball_rows.clear();
    for (const std::uint32_t k : islands) {
      const auto joints = in_.islands[k].joints.of(in_.joints);
      w_.joints.insert(w_.joints.end(), joints.begin(), joints.end());
    }
    if (w_.joints.empty()) return;
    w_.colours.assign(std::uint32_t(w_.joints.size()), std::uint32_t(w_.bodies.size()), [&](std::uint32_t k) {
      const auto answers = [&](std::uint32_t n) { return moves(n) ? n : 0u; };
      return std::array{answers(number(in_.joint_state.a[w_.joints[k]])), answers(number(in_.joint_state.b[w_.joints[k]]))};
    });
    w_.joint_places.resize(w_.joints.size());
    w_.colours.each_group(SoftLanes::count, [](std::uint32_t) { return 0; }, [&](std::uint32_t k, std::uint32_t group, std::uint32_t lane) {
      if (lane == 0) w_.ball_rows.emplace_back();
      w_.joint_places[k] = {group, lane};
      ++w_.ball_rows[group].used;
      fill(w_.joints[k], w_.ball_rows[group], lane);
    });
  }

  void store() {
    for (std::size_t k = 0; k < w_.joints.size(); ++k) {
      const auto [group, lane] = w_.joint_places[k];
      const Vec3 impulse = get(w_.ball_rows[group].impulse, lane);
      JointImpulse& out = in_.joint_state.impulse[w_.joints[k]];
      out = {};
      for (int i = 0; i < 3; ++i) out.rows[std::size_t(i)] = impulse[i];
    }
  }

 private:
  std::uint32_t number(std::uint32_t slot) const { return slot == no_body ? 0 : number_of_[slot]; }

  Vec3 arm(std::uint32_t slot, const Vec3& anchor) const {
    return slot == no_body ? Vec3{} : rotate(in_.bodies.orientation[slot], anchor);
  }

  void fill(std::uint32_t j, SoftBallRows& row, std::uint32_t lane) {
    const Joints& joints = in_.joint_state;
    row.a[lane] = number(joints.a[j]), row.b[lane] = number(joints.b[j]);
    set(row.ra, lane, arm(joints.a[j], joints.anchor_a[j])), set(row.rb, lane, arm(joints.b[j], joints.anchor_b[j]));
    set(row.gap, lane, anchor_a(joints, in_.bodies, j) - anchor_b(joints, in_.bodies, j));
    const auto& impulse = joints.impulse[j].rows;
    set(row.impulse, lane, {impulse[0], impulse[1], impulse[2]});
  }
};

}

void prepare_joints(const SoftBatch& batch, std::span<const std::uint32_t> islands) { JointRowsOfBatch(batch).prepare(islands); }
void store_joints(const SoftBatch& batch) { JointRowsOfBatch(batch).store(); }

}
