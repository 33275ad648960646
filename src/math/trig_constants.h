// The numbers behind trig.h, for float and for double. The polynomials are printed by tools/minimax.py.
#pragma once

#include <sudar/base.h>

namespace sudar::inline SUDAR_PRECISION {

// The constants of one precision. `half_pi` sums to π/2; k · (every part but the last) is exact for |k| < 2^16.
template <class S>
struct TrigConstants;

template <>
struct TrigConstants<float> {
  static constexpr float rounder = 0x1.8p23f;  // adding and taking it away rounds to an integer
  static constexpr float half_pi[] = {0x1.92p0f, 0x1.fcp-12f, -0x1.58p-21f, 0x1.1p-30f, 0x1.68p-39f, 0x1.84698ap-48f};
  static constexpr float quarter_pi[] = {0x1.92p-1f, 0x1.fb5444p-13f};  // the first times 4 and fewer is exact
  static constexpr float sine[] = {-0.166666549f, 0.00833217815f, -0.00019517299f};
  static constexpr float cosine[] = {0.0416666469f, -0.00138873675f, 2.44384525e-05f};
  static constexpr float arc_tangent[] = {-0.333333155f, 0.199984894f, -0.142438485f, 0.105959996f, -0.0608344804f};
  // Beyond `large` and below `small` a product or its error would over- or underflow: scale first.
  static constexpr float large = 0x1p110f, shrink = 0x1p-20f, small = 0x1p-70f, grow = 0x1p80f;
};

template <>
struct TrigConstants<double> {
  static constexpr double rounder = 0x1.8p52;
  static constexpr double half_pi[] = {0x1.921fb544p0, 0x1.0b4611a6p-34, 0x1.3198a2ep-69, 0x1.b839a252049c1p-104};
  static constexpr double quarter_pi[] = {0x1.921fb544p-1, 0x1.0b4611a626331p-35};
  static constexpr double sine[] = {-0.16666666666666632,   0.008333333333322425,    -0.00019841269829816926,
                                    2.7557313695225494e-06, -2.5050758653916423e-08, 1.5896828001031283e-10};
  static constexpr double cosine[] = {0.0416666666666666,     -0.001388888888887414,  2.4801587289492e-05,
                                      -2.755731435528728e-07, 2.0875723690228553e-09, -1.1359670155397816e-11};
  static constexpr double arc_tangent[] = {-0.333333333333332,   0.19999999999954085,  -0.14285714280248707,
                                           0.11111110786148139,  -0.09090897836745394, 0.07692061642292407,
                                           -0.06663120441200972, 0.05848009321365432,  -0.050398472854850426,
                                           0.038078364837349,    -0.01792232616952146};
  static constexpr double large = 0x1p990, shrink = 0x1p-60, small = 0x1p-900, grow = 0x1p200;
};

}
