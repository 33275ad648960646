/* A ball that bounces, as in examples/library: the same numbers and the same hash. */
#include <inttypes.h>
#include <stdio.h>
#include <sudar.h>

/* A body's definition, still without a place. */
static sudar_definition* body_of(sudar_shape* shape) {
  sudar_definition* body = sudar_define("body");
  sudar_set_shape(body, "shape", shape);
  sudar_set_number(body, "material.restitution", 0.8);
  sudar_shape_free(shape);
  return body;
}

static sudar_handle add(sudar_world* world, sudar_definition* definition) {
  const sudar_handle handle = sudar_add(world, definition);
  if (handle == SUDAR_NONE) fprintf(stderr, "%s\n", sudar_error());
  sudar_definition_free(definition);
  return handle;
}

int main(void) {
  sudar_world* world = sudar_world_new(NULL);
  add(world, sudar_define("gravity"));

  sudar_definition* floor = body_of(sudar_half_space());
  sudar_set_text(floor, "motion", "fixed");
  add(world, floor);

  sudar_definition* sphere = body_of(sudar_sphere(0.5));
  const double start[] = {0, 4, 0};
  sudar_set_numbers(sphere, "at", 3, start);
  const sudar_handle ball = add(world, sphere);

  for (int i = 0; i < 6; ++i) {
    double position[3];
    if (sudar_step(world, 30) != 0 || sudar_get_pose(world, ball, position, NULL) != 0) {
      fprintf(stderr, "%s\n", sudar_error());
      return 1;
    }
    printf("%3.1f s  %5.3f m\n", sudar_time(world), position[1]);
  }
  printf("%016" PRIx64 "\n", sudar_motion_hash(world));
  sudar_world_free(world);
  return 0;
}
