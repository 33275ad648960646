#include "math/trig.h"

namespace sudar::inline SUDAR_PRECISION {

float sin(float x) { return sin_cos(x).sin; }
float cos(float x) { return sin_cos(x).cos; }
float atan2(float y, float x) { return atan2(Pair<float>{y, 0}, Pair<float>{x, 0}); }
float acos(float x) { return acos_of(x); }
float asin(float x) { return asin_of(x); }
double sin(double x) { return sin_cos(x).sin; }
double cos(double x) { return sin_cos(x).cos; }
double atan2(double y, double x) { return atan2(Pair<double>{y, 0}, Pair<double>{x, 0}); }
double acos(double x) { return acos_of(x); }
double asin(double x) { return asin_of(x); }

float tan(float x) {
  const SinCos<float> a = sin_cos(x);
  return a.sin / a.cos;
}

double tan(double x) {
  const SinCos<double> a = sin_cos(x);
  return a.sin / a.cos;
}

}
