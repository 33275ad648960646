// A body that spins about the axis of its middle moment of inertia turns over, again and again, at intervals that
// Jacobi's elliptic functions give exactly (L. Poinsot, 1834; seen in orbit by V. Dzhanibekov, 1985).
#include "thesis.h"

using namespace sudar;

struct Dzhanibekov : Scenario {
  static constexpr double seconds = 40;
  static constexpr double picture = 5.2;
  static constexpr const char* about = "a wing nut in free fall turns over, again and again";
  Real spin = 3, tilt = 0.02;
  Body nut;
  double energy = 0, momentum = 0, turned_over[2] = {-1, -1};  // at the start; the last two times, s
  Real side = 1;                                               // sign of the spin about its own axis
  int turns = 0;

  void params(Params& p) override {
    p("spin", spin, 0.5, 20, "rad/s, about the middle axis"), p("tilt", tilt, 0.001, 1, "rad/s, about the long axis");
  }
  void state(State& s) override {
    s("nut", nut), s("energy", energy), s("momentum", momentum);
    s("turned_over", turned_over), s("side", side), s("turns", turns);
  }
  void config(Config& c) override { c = thesis_config(); }

  void build(World& w) override {
    const Vec3 outline[] = {{-2, Real(-0.7), 0}, {2, Real(-0.7), 0}, {0, Real(1.4), 0}};
    nut = w.add({.shape = prism(outline, 0.5), .spin = {tilt, spin, 0}, .density = 1, .sleeps = false});
    energy = w[nut].kinetic_energy(), momentum = length(w[nut].angular_momentum());
  }

  void observe(const World& w, Check& c) override {
    const Real now = rotate_back(w[nut].pose().q, w[nut].spin()).y;
    if (now * side < 0) {
      side = -side, turns += 1;
      turned_over[0] = turned_over[1], turned_over[1] = w.time();
    }
    c.near("kinetic energy / at the start", w[nut].kinetic_energy() / energy, 1, 1e-4);
    c.near("angular momentum / at the start", length(w[nut].angular_momentum()) / momentum, 1, 1e-6);
  }

  // K(k) = π / (2 agm(1, √(1 − k²))), C. F. Gauss.
  static double quarter_period(double k2) {
    double a = 1, b = sqrt(1 - k2);
    for (int i = 0; i < 8; ++i) {
      const double mean = (a + b) / 2;
      b = sqrt(a * b), a = mean;
    }
    return pi / (2 * a);
  }
  // The spin about the middle axis is a sn(pt, k): it changes sign every 2 K(k) / p (Landau & Lifshitz, Mechanics,
  // §37).
  double interval(const World& w) const {
    const Mat3 turn = matrix(w[nut].pose().q), own = transpose(turn) * w[nut].inertia() * turn;
    double i1 = own.c0.x, i3 = own.c2.z;
    const double i2 = own.c1.y, e2 = 2 * energy, l2 = square(momentum);
    if (l2 < e2 * i2) std::swap(i1, i3);
    const double p2 = (i3 - i2) * (l2 - e2 * i1) / (i1 * i2 * i3);
    const double k2 = (i2 - i1) * (e2 * i3 - l2) / ((i3 - i2) * (l2 - e2 * i1));
    return 2 * quarter_period(k2) / sqrt(p2);
  }
  void check(const World& w, Check& c) override {
    const double exact = interval(w);
    c.near("turns over", turns, std::floor(w.time() / exact + 0.5), 0);
    c.near("time between turns", turned_over[1] - turned_over[0], exact, 0.005 * exact, "s");
  }
  std::optional<Camera> camera() const override { return Camera{{2, 2.5, 7}, {0, 0, 0}}; }
};
SUDAR_SCENARIO(Dzhanibekov, "Motion/Dzhanibekov's nut")
