// Mass properties of solids in closed form: volume, centre of mass and inertia tensor for density 1 (shape.h), whether
// or not there is a shape of that form to collide with. For a body whose mass is not that of its shape:
//   const MassProperties hoop = mass_of(solid::Tube{.outer = 0.5, .inner = 0.49, .height = 0.1});
//   w.add({.shape = cylinder(0.5, 0.1), .mass = Real(m), .inertia = inertia_of(hoop, m)});
// Lengths in metres, the axis is y. Sizes that are no body throw Error naming the field.
#pragma once

#include <sudar/shape.h>

namespace sudar::inline SUDAR_PRECISION {

namespace solid {

struct Sphere { double radius; };
struct ThickShell { double outer, inner; };                  // between two spheres about the origin
struct Ellipsoid { Vec3d radii; };                           // a spheroid where two of them are equal
struct Box { Vec3d edges; };
struct Cylinder { double radius, height; };                  // this and the next, centred on the origin
struct Tube { double outer, inner, height; };
struct Capsule { double radius, length; };                   // `length` between the centres of the two ends
struct TaperedCapsule { double bottom, top, length; };       // the hull of two spheres, centres at y = ∓length/2
struct Torus { double ring, tube; };                         // radius of the middle circle, about y, and of the tube
struct Cone { double radius, height; };                      // base at y = 0, apex at y = height
struct Frustum { double bottom, top, height; };              // radii at y = 0 and y = height
struct Hemisphere { double radius; };                        // y ≥ 0
struct Cap { double radius, height; };                       // of a sphere about the origin: y ≥ radius − height
struct Paraboloid { double radius, height; };                // apex at the origin, open end at y = height

}

MassProperties mass_of(const solid::Sphere&);
MassProperties mass_of(const solid::ThickShell&);
MassProperties mass_of(const solid::Ellipsoid&);
MassProperties mass_of(const solid::Box&);
MassProperties mass_of(const solid::Cylinder&);
MassProperties mass_of(const solid::Tube&);
MassProperties mass_of(const solid::Capsule&);
MassProperties mass_of(const solid::TaperedCapsule&);
MassProperties mass_of(const solid::Torus&);
MassProperties mass_of(const solid::Cone&);
MassProperties mass_of(const solid::Frustum&);
MassProperties mass_of(const solid::Hemisphere&);
MassProperties mass_of(const solid::Cap&);
MassProperties mass_of(const solid::Paraboloid&);

// The inertia tensor [kg·m²] about the centre of mass if the solid has this mass [kg]: what BodyDef::inertia takes.
Mat3 inertia_of(const MassProperties&, double mass);

}
