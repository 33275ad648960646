#include "joints/chain.h"

using namespace sudar;

struct Chain : ChainScene {
  static constexpr const char* about = "a falling chain of plates with hinges (thesis, fig. 13)";
  Chain() { edges = {2.5, 0.5, 2}, density = 10; }
  JointDef joint(Body before, Body link, const Pos& at) const override {
    return Hinge{.a = before, .b = link, .at = at};
  }
};
SUDAR_SCENARIO(Chain, "Joints/Chain with hinges")
