// The operations on a world as data: what the public functions do is recorded as one of these, and replayed from it.
#pragma once

#include <sudar/world.h>

#include "geometry/archive.h"

namespace sudar::inline SUDAR_PRECISION {

struct AddBody { BodyDef def; };
struct AddForce { Force def; };
struct AddSensor { Sensor def; };
struct AddJoint { JointDef def; };
struct RemoveBody { Body body; };
struct RemoveJoint { Joint joint; };
struct RemoveForce { ForceId force; };
struct RemoveSensor { SensorId sensor; };
struct Push { Body body; Vec3 force; Pos at; };
struct Place { Body body; Pos at; Quat turn; };
struct SetVelocity { Body body; Vec3 velocity, spin; };
struct SetDrive { Joint joint; Drive drive; };
struct SetConfig { Config config; };
struct Wake { Body body; };
struct Torque { Body body; Vec3 torque; };
struct Load { Bytes state; };
struct SetSurfaceVelocity { Body body; Vec3 velocity; };
struct SetPairMaterial { Body a, b; std::optional<Material> material; };
struct AddShape { Body body; ShapeDef def; };
struct RemoveShape { ShapeId shape; };

template <class V, class T>
  requires(Like<T, AddBody> || Like<T, AddForce> || Like<T, AddSensor> || Like<T, AddJoint>)
void describe(V& v, T& o) { v("", o.def, any); }
template <class V, class T>
  requires(Like<T, RemoveBody> || Like<T, Wake>)
void describe(V& v, T& o) { v("body", o.body, any); }
template <class V, Like<RemoveJoint> T>
void describe(V& v, T& o) { v("joint", o.joint, any); }
template <class V, Like<RemoveForce> T>
void describe(V& v, T& o) { v("force", o.force, any); }
template <class V, Like<RemoveSensor> T>
void describe(V& v, T& o) { v("sensor", o.sensor, any); }
template <class V, Like<Push> T>
void describe(V& v, T& o) { v("body", o.body, any), v("force", o.force, any_finite), v("at", o.at, any); }
template <class V, Like<Place> T>
void describe(V& v, T& o) { v("body", o.body, any), v("at", o.at, any), v("turn", o.turn, unit_length); }
template <class V, Like<SetVelocity> T>
void describe(V& v, T& o) { v("body", o.body, any), v("velocity", o.velocity, any), v("spin", o.spin, any); }
template <class V, Like<Torque> T>
void describe(V& v, T& o) { v("body", o.body, any), v("torque", o.torque, any_finite); }
template <class V, Like<SetDrive> T>
void describe(V& v, T& o) { v("joint", o.joint, any), v("drive", o.drive, any); }
template <class V, Like<SetConfig> T>
void describe(V& v, T& o) { v("config", o.config, any); }
template <class V, Like<Load> T>
void describe(V& v, T& o) { v("state", o.state, any); }
template <class V, Like<SetSurfaceVelocity> T>
void describe(V& v, T& o) { v("body", o.body, any), v("surface_velocity", o.velocity, any); }
template <class V, Like<SetPairMaterial> T>
void describe(V& v, T& o) { v("a", o.a, any), v("b", o.b, any), v("material", o.material, any); }

template <class V, Like<AddShape> T>
void describe(V& v, T& o) { v("body", o.body, any), v("", o.def, any); }
template <class V, Like<RemoveShape> T>
void describe(V& v, T& o) { v("shape", o.shape, any); }

using Operation = std::variant<std::monostate
#define OP(name) , name
#include "world/ops.def"
                               >;
inline void write(Writer&, const std::monostate&) {}
inline void read(Reader&, std::monostate&) {}

}
