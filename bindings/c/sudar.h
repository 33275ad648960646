/* Sudar in C, for other languages: the same engine, the same bits.
 *
 *   sudar_world* world = sudar_world_new(NULL);
 *   sudar_definition* gravity = sudar_define("gravity");
 *   sudar_add(world, gravity);
 *   sudar_definition* ball = sudar_define("body");
 *   sudar_set_shape(ball, "shape", sudar_sphere(0.5));
 *   sudar_set_numbers(ball, "at", 3, (double[]){0, 4, 0});
 *   sudar_set_number(ball, "material.restitution", 0.8);
 *   sudar_handle body = sudar_add(world, ball);
 *   sudar_step(world, 600);
 *
 * Definitions are those of sudar/definitions.h, their fields set by name: what is added there can be set here at once.
 * SI units, radians, y up; orientations are quaternions x, y, z, w. Whatever goes wrong is told by the return value,
 * and sudar_error() says what it was; nothing has changed then. No function throws or exits. A pointer that a function
 * returned is the caller's, to be freed by the function named so; NULL may be freed. A world is used by one thread at a
 * time.
 */
#ifndef SUDAR_H
#define SUDAR_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct sudar_world sudar_world;
typedef struct sudar_definition sudar_definition;
typedef struct sudar_shape sudar_shape;

/* A body, joint, force or sensor; dead once it was removed. */
typedef uint64_t sudar_handle;
/* Nothing: what sudar_add() returns when it fails. As a body of a joint: the world. */
#define SUDAR_NONE UINT64_MAX

/* What the last function of this thread that failed had to say, and the field that was wrong ("material.restitution");
 * both "" before the first failure, and valid until the next one. */
const char* sudar_error(void);
const char* sudar_error_field(void);
const char* sudar_version(void);

/* --- shapes, m; NULL: bad sizes --- */
sudar_shape* sudar_sphere(double radius);
sudar_shape* sudar_capsule(double radius, double length);
sudar_shape* sudar_cylinder(double radius, double height);
sudar_shape* sudar_cone(double radius, double height);
sudar_shape* sudar_box(double x, double y, double z);
sudar_shape* sudar_half_space(void);
sudar_shape* sudar_hull(const double* points, size_t count); /* 3 numbers a point */
void sudar_shape_free(sudar_shape*);                         /* definitions that were given it keep their own */

/* --- definitions --- */
/* kind: "body", "config", "sensor", a joint ("hinge", "ball", ...) or a force ("gravity", "drag", ...). NULL: no such
 * kind. */
sudar_definition* sudar_define(const char* kind);
void sudar_definition_free(sudar_definition*);
/* `path` is a field, or one in a field: "material.restitution", "shapes[1].at". 0: done; else sudar_error(). */
int sudar_set_number(sudar_definition*, const char* path,
                     double value); /* numbers, whole numbers, truth values (0 or 1) */
int sudar_set_numbers(sudar_definition*, const char* path, size_t count,
                      const double* values);                                /* vectors, quaternions, matrices by rows */
int sudar_set_text(sudar_definition*, const char* path, const char* value); /* names, and choices: "fixed" */
int sudar_set_shape(sudar_definition*, const char* path, const sudar_shape*);
int sudar_set_body(sudar_definition*, const char* path, sudar_handle);

/* --- worlds --- */
sudar_world* sudar_world_new(const sudar_definition* config); /* NULL: as usual */
void sudar_world_free(sudar_world*);
sudar_handle sudar_add(sudar_world*, const sudar_definition*); /* SUDAR_NONE: sudar_error() */
int sudar_remove(sudar_world*, sudar_handle);
int sudar_step(sudar_world*, size_t steps);
double sudar_time(const sudar_world*);          /* simulated, s */
uint64_t sudar_hash(const sudar_world*);        /* of everything that can change a later bit */
uint64_t sudar_motion_hash(const sudar_world*); /* of poses and velocities */

/* --- bodies and joints; each returns 0, else sudar_error() --- */
int sudar_get_pose(const sudar_world*, sudar_handle body, double position[3], double orientation[4]);
int sudar_get_velocity(const sudar_world*, sudar_handle body, double velocity[3], double spin[3]);
int sudar_set_pose(sudar_world*, sudar_handle body, const double position[3], const double orientation[4]);
int sudar_set_velocity(sudar_world*, sudar_handle body, const double velocity[3], const double spin[3]);
int sudar_push(sudar_world*, sudar_handle body, const double force[3],
               const double at[3]); /* during the next step; at NULL: centre of mass */
int sudar_twist(sudar_world*, sudar_handle body, const double torque[3]);
int sudar_get_coordinate(const sudar_world*, sudar_handle joint, double* coordinate);
/* The nearest body on the way along a unit vector: 1 found, 0 none, −1 sudar_error(). at, normal: NULL where not
 * wanted. */
int sudar_ray_cast(const sudar_world*, const double from[3], const double direction[3], double length,
                   sudar_handle* body, double at[3], double normal[3]);

/* --- state: a world that loads it goes on with the same bits --- */
size_t sudar_save(const sudar_world*, void* buffer,
                  size_t size); /* the size needed; written when it fits; 0: sudar_error() */
int sudar_load(sudar_world*, const void* data, size_t size);

#ifdef __cplusplus
}
#endif

#endif
