#include "view/ground.h"

#include <cmath>

namespace sudar::view {

namespace {

// Edge of a grid cell for a picture taken from this distance: 1, 10, 100 … m.
double cell_for(double distance) { return std::pow(10.0, std::floor(std::log10(distance / 6))); }

}

Ground::Ground(const std::vector<std::string>& light)
    : floors_({"frame.glsl", "ground.vert.glsl"}, gl::joined(light, "ground.frag.glsl")),
      walls_({"frame.glsl", "ground.vert.glsl"}, gl::joined(gl::joined(light, "glass.glsl"), "ground.frag.glsl")) {}

void Ground::draw(const Scene& scene, const Camera& camera, const Focus& focus, bool glass) const {
  const double distance = double(length(relative(camera.target, camera.eye)));
  const double cell = cell_for(distance), coarse = 10 * cell;
  const gl::Program& program = glass ? walls_ : floors_;
  program.use();
  glBindVertexArray(none_);
  for (const Instance& i : scene.instances) {
    if (scene.shapes[i.shape].kind() != ShapeKind::half_space) continue;
    const Vec3 up = rotate(i.pose.q, Vec3{0, 1, 0}), x = rotate(i.pose.q, Vec3{1, 0, 0}),
               z = rotate(i.pose.q, Vec3{0, 0, 1});
    if ((double(up.y) < 0.5) != glass) continue;
    const Vec3 eye = i.pose.local(camera.eye);
    if (eye.y <= 0) continue;
    // Floors lie round the point below the eye, walls round the scene.
    const Vec3 middle = glass ? i.pose.local(focus.centre) : eye;
    const Pos centre = i.pose.point({middle.x, 0, middle.z});
    program.set("centre", relative(centre, camera.eye));
    program.set("side_x", to_float(x));
    program.set("side_z", to_float(z));
    program.set("normal", to_float(up));
    program.set("reach", float(glass ? 2 * (focus.radius + double(abs(middle.y))) : 100 * distance));
    program.set("offset", float(std::fmod(double(middle.x), coarse)), float(std::fmod(double(middle.z), coarse)));
    program.set("cell", float(cell));
    program.set("scene_centre", relative(focus.centre, camera.eye));
    // As far as the wall is from the scene it may also spread, or it would not be seen at all.
    program.set("scene_radius", float(focus.radius) + abs(float(middle.y)));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
}

}
