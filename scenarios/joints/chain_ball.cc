#include "joints/chain.h"

using namespace sudar;

struct ChainBall : ChainScene {
  static constexpr const char* about = "a falling chain of rods with ball joints";
  ChainBall() { edges = {2.5, 0.5, 0.5}; }
  JointDef joint(Body before, Body link, const Pos& at) const override {
    return Ball{.a = before, .b = link, .at = at};
  }
};
SUDAR_SCENARIO(ChainBall, "Joints/Chain with ball joints")
