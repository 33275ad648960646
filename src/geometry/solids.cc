// Closed forms for solids.h. Most solids here are bodies of revolution about y whose squared radius is a quadratic
// polynomial of the height, f(t) = a + b t + c t² for 0 ≤ t ≤ h: cones, frusta, parts of spheres, paraboloids. Cut into
// discs of mass π f dt and inertia ½ f per mass about y, ¼ f + t² per mass about a diameter through t = 0, they need
// only the integrals of f, t f, t² f and f², all of them polynomials. Others follow by difference and by Steiner's
// theorem. The textbook formulas are those of E. W. Weisstein, MathWorld, "Moment of Inertia".
#include <sudar/solids.h>

namespace sudar::inline SUDAR_PRECISION {

namespace {

void check(const char* field, double size) {
  if (!std::isfinite(size) || !(size > 0)) throw Error(field, "must be a positive number");
}

MassProperties round_about_y(double volume, double height, double along, double across) {
  return {volume, {0, height, 0}, Mat3d::diagonal({across, along, across})};
}

// Of f(t) = a + b t + c t² above y = base.
MassProperties revolved(double a, double b, double c, double base, double h) {
  const double volume = pi * h * (a + h * (b / 2 + h * c / 3));              // π ∫ f
  const double first = pi * h * h * (a / 2 + h * (b / 3 + h * c / 4));       // π ∫ t f
  const double second = pi * h * h * h * (a / 3 + h * (b / 4 + h * c / 5));  // π ∫ t² f
  const double along = pi / 2 * h *                                          // π/2 ∫ f²
                       (a * a + h * (a * b + h * ((b * b + 2 * a * c) / 3 + h * (b * c / 2 + h * c * c / 5))));
  const double center = first / volume;
  return round_about_y(volume, base + center, along, along / 2 + second - first * center);
}

// Of a ball about y = center, the part between y = center + low and y = center + high.
MassProperties zone(double radius, double center, double low, double high) {
  return revolved((radius - low) * (radius + low), -2 * low, -1, center + low, high - low);
}

MassProperties frustum(double bottom, double top, double base, double height) {
  const double slope = (top - bottom) / height;
  return revolved(bottom * bottom, 2 * bottom * slope, slope * slope, base, height);
}

Mat3d about(const MassProperties& m, const Vec3d& point) {  // Steiner
  const Vec3d d = m.center - point;
  return m.inertia + (Mat3d::identity() * length_squared(d) - Mat3d::outer(d, d)) * m.volume;
}

MassProperties sum(const MassProperties& p, const MassProperties& q) {
  MassProperties m{p.volume + q.volume, {}, {}};
  m.center = (p.center * p.volume + q.center * q.volume) / m.volume;
  m.inertia = about(p, m.center) + about(q, m.center);
  return m;
}

// A hole with the same centre.
MassProperties difference(const MassProperties& p, const MassProperties& hole) {
  return {p.volume - hole.volume, p.center, p.inertia - hole.inertia};
}

}

MassProperties mass_of(const solid::Sphere& s) {  // 2/5 m r²
  check("radius", s.radius);
  const double r = s.radius, volume = 4.0 / 3 * pi * r * r * r;
  return {volume, {}, Mat3d::identity() * (0.4 * volume * r * r)};
}

MassProperties mass_of(const solid::ThickShell& s) {
  check("inner", s.inner);
  if (!(s.outer > s.inner)) throw Error("outer", "must be greater than inner");
  return difference(mass_of(solid::Sphere{s.outer}), mass_of(solid::Sphere{s.inner}));
}

MassProperties mass_of(const solid::Ellipsoid& s) {  // m (b² + c²)/5
  const char* names[] = {"radii.x", "radii.y", "radii.z"};
  for (int i = 0; i < 3; ++i) check(names[i], s.radii[i]);
  const Vec3d q = scale(s.radii, s.radii);
  const double volume = 4.0 / 3 * pi * s.radii.x * s.radii.y * s.radii.z;
  return {volume, {}, Mat3d::diagonal(Vec3d{q.y + q.z, q.z + q.x, q.x + q.y} * (volume / 5))};
}

MassProperties mass_of(const solid::Box& s) {  // m (b² + c²)/12
  const char* names[] = {"edges.x", "edges.y", "edges.z"};
  for (int i = 0; i < 3; ++i) check(names[i], s.edges[i]);
  const Vec3d q = scale(s.edges, s.edges);
  const double volume = s.edges.x * s.edges.y * s.edges.z;
  return {volume, {}, Mat3d::diagonal(Vec3d{q.y + q.z, q.z + q.x, q.x + q.y} * (volume / 12))};
}

MassProperties mass_of(const solid::Cylinder& s) {  // m r²/2 and m (3 r² + h²)/12
  check("radius", s.radius), check("height", s.height);
  const double rr = s.radius * s.radius, volume = pi * rr * s.height;
  return round_about_y(volume, 0, volume * rr / 2, volume * (rr / 4 + s.height * s.height / 12));
}

MassProperties mass_of(const solid::Tube& s) {
  check("inner", s.inner), check("height", s.height);
  if (!(s.outer > s.inner)) throw Error("outer", "must be greater than inner");
  return difference(mass_of(solid::Cylinder{s.outer, s.height}), mass_of(solid::Cylinder{s.inner, s.height}));
}

// A cylinder and two half balls whose centres of mass are 3/8 r beyond its ends.
MassProperties mass_of(const solid::Capsule& s) {
  check("radius", s.radius), check("length", s.length);
  const double r = s.radius, half = s.length / 2;
  const double cylinder = 2 * half * pi * r * r, ball = 4.0 / 3 * pi * r * r * r;
  const double along = 0.5 * cylinder * r * r + 0.4 * ball * r * r;
  const double across = cylinder * (r * r / 4 + half * half / 3) + ball * (0.4 * r * r + half * half + 0.75 * half * r);
  return {cylinder + ball, {}, Mat3d::diagonal({across, along, across})};
}

// The cone that touches both spheres leaves each at the height r sin α, sin α = (r₁ − r₂)/length, with the radius
// r cos α.
MassProperties mass_of(const solid::TaperedCapsule& s) {
  check("bottom", s.bottom), check("top", s.top), check("length", s.length);
  const double sine = (s.bottom - s.top) / s.length, half = s.length / 2;
  if (!(abs(sine) < 1)) throw Error("length", "must be greater than the difference of the radii");
  const double cosine = sqrt((1 - sine) * (1 + sine));
  const MassProperties ends =
      sum(zone(s.bottom, -half, -s.bottom, s.bottom * sine), zone(s.top, half, s.top * sine, s.top));
  const double low = -half + s.bottom * sine, high = half + s.top * sine;
  return sum(ends, frustum(s.bottom * cosine, s.top * cosine, low, high - low));
}

MassProperties mass_of(const solid::Torus& s) {  // m (R² + ¾ r²) and m (R²/2 + 5/8 r²)
  check("tube", s.tube), check("ring", s.ring);
  if (s.ring < s.tube) throw Error("ring", "must not be less than tube");
  const double rr = s.tube * s.tube, qq = s.ring * s.ring, volume = 2 * pi * pi * s.ring * rr;
  return round_about_y(volume, 0, volume * (qq + 0.75 * rr), volume * (qq / 2 + 0.625 * rr));
}

MassProperties mass_of(const solid::Cone& s) {  // 3/10 m r² and 3/20 m (r² + h²/4), h/4 above the base
  check("radius", s.radius), check("height", s.height);
  const double rr = s.radius * s.radius, volume = pi / 3 * rr * s.height;
  return round_about_y(volume, s.height / 4, 0.3 * volume * rr, 0.15 * volume * (rr + s.height * s.height / 4));
}

MassProperties mass_of(const solid::Frustum& s) {
  check("bottom", s.bottom), check("top", s.top), check("height", s.height);
  return frustum(s.bottom, s.top, 0, s.height);
}

MassProperties mass_of(const solid::Hemisphere& s) {  // centre 3/8 r; 2/5 m r² and 83/320 m r²
  check("radius", s.radius);
  return zone(s.radius, 0, 0, s.radius);
}

MassProperties mass_of(const solid::Cap& s) {
  check("radius", s.radius), check("height", s.height);
  if (s.height > 2 * s.radius) throw Error("height", "must not be greater than the diameter");
  return zone(s.radius, 0, s.radius - s.height, s.radius);
}

MassProperties mass_of(const solid::Paraboloid& s) {  // f = r² t/h; centre 2/3 h
  check("radius", s.radius), check("height", s.height);
  return revolved(0, s.radius * s.radius / s.height, 0, 0, s.height);
}

Mat3 inertia_of(const MassProperties& m, double mass) {
  const Mat3d tensor = m.inertia * (mass / m.volume);
  return {convert<Real>(tensor.c0), convert<Real>(tensor.c1), convert<Real>(tensor.c2)};
}

}
