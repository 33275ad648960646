// The error bounds that math.h states, against the C library's long double: 64 bits of significand on x86. Where long
// double is no wider than double, only float is measured.
#include "math/trig.h"

#include "base/hash.h"
#include "unit/random.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

using sudar_test::Random;

namespace {

using Long = long double;
constexpr bool wide = std::numeric_limits<Long>::digits > std::numeric_limits<double>::digits;

template <class T>
using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

// The number `steps` places after x.
template <class T>
T step(T x, int steps) {
  Bits<T> bits;
  std::memcpy(&bits, &x, sizeof x);
  bits += Bits<T>(steps);
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

// |got − exact| in units of the last place of `exact` as a T.
template <class T>
double error_in_ulp(T got, Long exact) {
  int exponent;
  std::frexp(exact, &exponent);
  exponent = std::max(exponent, std::numeric_limits<T>::min_exponent);
  return double(std::abs(Long(got) - exact) / std::ldexp(Long(1), exponent - std::numeric_limits<T>::digits));
}

template <class T>
class Trig : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(Trig, Precisions);

#define NEEDS_WIDE(T) \
  if (sizeof(T) == 8 && !wide) GTEST_SKIP() << "long double is no wider than double here"

TYPED_TEST(Trig, SineCosineTangentWithin1e5) {
  using T = TypeParam;
  NEEDS_WIDE(T);
  Random random;
  double worst_sin = 0, worst_cos = 0, worst_tan = 0;
  const auto probe = [&](T x) {
    const Long s = std::sin(Long(x)), c = std::cos(Long(x));
    worst_sin = std::max(worst_sin, error_in_ulp(sudar::sin(x), s));
    worst_cos = std::max(worst_cos, error_in_ulp(sudar::cos(x), c));
    worst_tan = std::max(worst_tan, error_in_ulp(sudar::tan(x), s / c));
  };
  for (int i = 0; i < 3'000'000; ++i) {
    const double f = 2 * random.fraction() - 1;
    probe(T(f * (i % 3 == 0 ? 4 : i % 3 == 1 ? 100 : 1e5)));
  }
  // Around the multiples of π/4, where the reduced argument vanishes or changes its branch.
  for (int k = 1; k < 120'000; k += k < 2000 ? 1 : 7) {
    for (int d = -2; d <= 2; ++d) probe(step(T(Long(k) * 0.785398163397448309616L), d));
  }
  for (T x = T(0.5); x > std::numeric_limits<T>::min(); x /= 3) probe(x);
  EXPECT_LT(worst_sin, 1);
  EXPECT_LT(worst_cos, 1);
  EXPECT_LT(worst_tan, 2.5);
  this->RecordProperty("sin_ulp", std::to_string(worst_sin));
  this->RecordProperty("cos_ulp", std::to_string(worst_cos));
  this->RecordProperty("tan_ulp", std::to_string(worst_tan));
}

TYPED_TEST(Trig, ArcTangent) {
  using T = TypeParam;
  NEEDS_WIDE(T);
  Random random;
  double worst = 0;
  const auto probe = [&](T y, T x) {
    worst = std::max(worst, error_in_ulp(sudar::atan2(y, x), std::atan2(Long(y), Long(x))));
  };
  for (int i = 0; i < 2'000'000; ++i) {
    const T angle = T(2 * random.fraction() - 1) * T(3.2), length = T(std::exp2(40 * random.fraction() - 20));
    probe(length * sudar::sin(angle), length * sudar::cos(angle));
    probe(T(std::exp2(40 * random.fraction() - 20)), T(std::exp2(40 * random.fraction() - 20)));
  }
  const T tiny = std::numeric_limits<T>::min(), huge = std::numeric_limits<T>::max();
  for (const T y : {-huge, -huge / 3, T(-1), -tiny * 7, T(0), tiny * 5, T(1), T(1e30), huge / 2, huge}) {
    for (const T x : {-huge, T(-2e20), T(-1), -tiny * 3, tiny * 3, T(1), T(3e20), huge / 5, huge}) probe(y, x);
  }
  EXPECT_LT(worst, 1);
  this->RecordProperty("atan2_ulp", std::to_string(worst));
}

TYPED_TEST(Trig, ArcSineAndCosine) {
  using T = TypeParam;
  NEEDS_WIDE(T);
  Random random;
  double worst_asin = 0, worst_acos = 0;
  const auto probe = [&](T x) {
    worst_asin = std::max(worst_asin, error_in_ulp(sudar::asin(x), std::asin(Long(x))));
    worst_acos = std::max(worst_acos, error_in_ulp(sudar::acos(x), std::acos(Long(x))));
  };
  for (int i = 0; i < 1'000'000; ++i) {
    const T f = T(2 * random.fraction() - 1);
    probe(f);
    probe(i % 2 ? T(1) - abs(f) * T(std::exp2(-50 * random.fraction())) : f * T(std::exp2(-60 * random.fraction())));
  }
  for (const T x : {T(-1), T(0), T(1)}) probe(x);
  EXPECT_LT(worst_asin, 1);
  EXPECT_LT(worst_acos, 1);
  this->RecordProperty("asin_ulp", std::to_string(worst_asin));
  this->RecordProperty("acos_ulp", std::to_string(worst_acos));
}

TYPED_TEST(Trig, ExactValues) {
  using T = TypeParam;
  const T p = T(sudar::pi);
  EXPECT_EQ(sudar::sin(T(0)), T(0));
  EXPECT_EQ(sudar::cos(T(0)), T(1));
  EXPECT_EQ(sudar::atan2(T(0), T(0)), T(0));
  EXPECT_EQ(sudar::atan2(T(0), T(1)), T(0));
  EXPECT_EQ(sudar::atan2(T(0), T(-1)), p);
  EXPECT_EQ(sudar::atan2(T(1), T(0)), p / 2);
  EXPECT_EQ(sudar::atan2(T(-1), T(0)), -p / 2);
  EXPECT_EQ(sudar::atan2(T(1), T(1)), p / 4);
  EXPECT_EQ(sudar::acos(T(1)), T(0));
  EXPECT_EQ(sudar::acos(T(-1)), p);
  EXPECT_EQ(sudar::asin(T(1)), p / 2);
}

TYPED_TEST(Trig, OddEvenAndBounded) {
  using T = TypeParam;
  Random random;
  for (int i = 0; i < 100'000; ++i) {
    const T x = T(1e5 * random.fraction());
    ASSERT_EQ(sudar::sin(-x), -sudar::sin(x));
    ASSERT_EQ(sudar::cos(-x), sudar::cos(x));
    const T far = T(std::exp2(sizeof(T) * 16 * random.fraction()));  // far beyond where the sine is exact
    const T s = sudar::sin(far), c = sudar::cos(far);
    ASSERT_LE(s * s + c * c, T(2));
  }
}

TYPED_TEST(Trig, NotFiniteStaysVisible) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinity = std::numeric_limits<T>::infinity();
  EXPECT_TRUE(std::isnan(sudar::sin(nan)) && std::isnan(sudar::cos(nan)) && std::isnan(sudar::tan(nan)));
  EXPECT_TRUE(std::isnan(sudar::sin(infinity)) && std::isnan(sudar::cos(-infinity)));
  EXPECT_TRUE(std::isnan(sudar::atan2(nan, T(1))) && std::isnan(sudar::atan2(T(1), nan)));
  EXPECT_TRUE(std::isnan(sudar::asin(T(1.001))) && std::isnan(sudar::acos(T(-1.001))) && std::isnan(sudar::acos(nan)));
}

// The same bits from every compiler on every machine: these values must never change.
TYPED_TEST(Trig, PinnedBits) {
  using T = TypeParam;
  Random random;
  sudar::Hasher hasher;
  for (int i = 0; i < 100'000; ++i) {
    const T x = T(random.between(-1, 1)), wide = x * T(1000), y = T(random.between(-1, 1));
    hasher.add(sudar::sin(wide)).add(sudar::cos(wide)).add(sudar::tan(wide));
    hasher.add(sudar::atan2(y, x)).add(sudar::asin(x)).add(sudar::acos(x));
  }
  EXPECT_EQ(hasher.value(), sizeof(T) == 4 ? 3798032975673865839u : 6559588183124315817u);
}

}
