#include "view/renderer.h"

#include <algorithm>
#include <stdexcept>

#include "view/bodies.h"
#include "view/boxes.h"
#include "view/buffers.h"
#include "view/frame.h"
#include "view/ground.h"
#include "view/marks.h"

namespace sudar::view {

namespace {

// Texture units and the place of the frame block, the same in all programs.
enum Unit { shadow_unit, light_unit, depth_unit, occlusion_unit };
constexpr GLuint frame_binding = 0;

void begin_pass(GLuint framebuffer, int width, int height, bool depth_test) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  (depth_test ? glEnable : glDisable)(GL_DEPTH_TEST);
}

using Files = std::vector<std::string>;

// What makes light into a picture, in several passes or in one.
struct Lit {
  gl::Program body, ghost, mark, sky;
  Ground ground;

  explicit Lit(const Files& light)
      : body({"frame.glsl", "body.vert.glsl"}, gl::joined(light, "body.frag.glsl")),
        ghost({"frame.glsl", "body.vert.glsl"}, gl::joined(light, "ghost.frag.glsl")),
        mark({"frame.glsl", "body.vert.glsl"}, gl::joined(light, "mark.frag.glsl")),
        sky({"screen.vert.glsl"}, gl::joined(light, "sky.frag.glsl")),
        ground(light) {}
};

}

struct Renderer::Impl {
  Lit fine{Files{"fine.glsl", "frame.glsl", "light.glsl"}};
  Lit plain{Files{"tone.glsl", "plain.glsl", "frame.glsl", "light.glsl"}};
  gl::Program shadow{{"frame.glsl", "body.vert.glsl"}, {"empty.frag.glsl"}};
  gl::Program id{{"frame.glsl", "body.vert.glsl"}, {"id.frag.glsl"}};
  gl::Program occlusion{{"screen.vert.glsl"}, {"frame.glsl", "occlusion.frag.glsl"}};
  gl::Program resolve{{"screen.vert.glsl"}, {"tone.glsl", "resolve.frag.glsl"}};
  gl::VertexArray none = gl::make_vertex_array();  // for triangles that a shader makes from nothing
  gl::Buffer frame_buffer = gl::make_buffer();
  Bodies bodies;
  Boxes boxes;
  Marks marks;
  std::optional<Layers> layers;
  std::optional<ShadowMap> shadow_map;

  Impl() {
    const gl::Program* const all[] = {&fine.body,
                                      &fine.ghost,
                                      &plain.ghost,
                                      &fine.mark,
                                      &fine.sky,
                                      &fine.ground.floors(),
                                      &fine.ground.walls(),
                                      &plain.body,
                                      &plain.mark,
                                      &plain.sky,
                                      &plain.ground.floors(),
                                      &plain.ground.walls(),
                                      &shadow,
                                      &id,
                                      &occlusion,
                                      &resolve};
    for (const gl::Program* p : all) {
      p->bind_block("Frame", frame_binding);
      p->use();
      p->set("shadow_map", shadow_unit);
      p->set("light_map", light_unit);
      p->set("depth", depth_unit);
      p->set("occlusion", occlusion_unit);
    }
    shadow.use();
    shadow.set("from_sun", 1);
  }

  void share(const FrameBlock& frame) {
    glBindBuffer(GL_UNIFORM_BUFFER, frame_buffer);
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, frame_binding, frame_buffer);
  }

  const Lit& lit() const { return layers->plain ? plain : fine; }

  void draw_screen() const {
    glBindVertexArray(none);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

  void draw_shadows() const {
    begin_pass(shadow_map->framebuffer, shadow_map->texels, shadow_map->texels, true);
    glClear(GL_DEPTH_BUFFER_BIT);
    glEnable(GL_DEPTH_CLAMP);  // what stands nearer to the sun than the map's box casts its shadow all the same
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1.5f, 2.0f);
    shadow.use();
    bodies.draw_for_shadows();
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
  }

  void draw_solids(const Scene& scene, const Camera& camera, const Focus& focus, const Style& style) const {
    begin_pass(layers->framebuffer, layers->width * layers->samples, layers->height * layers->samples, true);
    glClear(GL_DEPTH_BUFFER_BIT);
    gl::bind(shadow_unit, shadow_map->depth);
    glEnable(GL_CULL_FACE);
    if (style.wireframe) glPolygonMode(GL_FRONT_AND_BACK, GL_LINE), glLineWidth(float(layers->samples));
    lit().body.use();
    bodies.draw();
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glLineWidth(1);
    glDisable(GL_CULL_FACE);
    lit().ground.draw(scene, camera, focus, false);
    glDepthFunc(GL_LEQUAL);  // the sky lies exactly on the far plane
    lit().sky.use();
    draw_screen();
    glDepthFunc(GL_LESS);
  }

  void draw_occlusion() const {
    begin_pass(layers->occlusion_framebuffer, layers->width, layers->height, false);
    gl::bind(depth_unit, layers->depth);
    occlusion.use();
    draw_screen();
  }

  void draw_over(const Scene& scene, const Camera& camera, const Focus& focus) const {
    begin_pass(layers->framebuffer, layers->width * layers->samples, layers->height * layers->samples, true);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    glDepthMask(GL_FALSE);
    lit().ground.draw(scene, camera, focus, true);
    if (bodies.any_ghosts()) {
      glEnable(GL_CULL_FACE);
      lit().ghost.use();
      bodies.draw_ghosts();
      glDisable(GL_CULL_FACE);
    }
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
  }

  void draw_boxes() const {
    begin_pass(layers->framebuffer, layers->width * layers->samples, layers->height * layers->samples, true);
    glDepthMask(GL_FALSE);
    glLineWidth(float(layers->samples));
    lit().mark.use();
    boxes.draw();
    glLineWidth(1);
    glDepthMask(GL_TRUE);
  }

  // Marks hide each other but nothing hides them: they have a depth buffer of their own.
  void draw_marks() const {
    begin_pass(layers->mark_framebuffer, layers->width * layers->samples, layers->height * layers->samples, true);
    glClear(GL_DEPTH_BUFFER_BIT);
    lit().mark.use();
    marks.draw();
  }

  void finish(const Style& style, const Target& target) const {
    if (layers->plain) {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, layers->framebuffer);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, target.framebuffer);
      glBlitFramebuffer(0, 0, layers->width, layers->height, 0, 0, target.width, target.height, GL_COLOR_BUFFER_BIT,
                        GL_NEAREST);
      return;
    }
    begin_pass(target.framebuffer, target.width, target.height, false);
    gl::bind(light_unit, layers->light);
    gl::bind(depth_unit, layers->depth);
    gl::bind(occlusion_unit, layers->occlusion);
    resolve.use();
    resolve.set("samples", layers->samples);
    resolve.set("occluded", style.occlusion ? 1 : 0);
    draw_screen();
  }
};

void Style::set(Finish finish) {
  const bool fine = finish == Finish::fine;
  plain = !fine;
  occlusion = fine;
  samples = fine ? 2 : 1;
  shadow_texels = fine ? 2048 : 1024;
}

Renderer::Renderer() {
  if (epoxy_gl_version() < 33) {
    throw std::runtime_error("drawing needs OpenGL 3.3; this driver has " + std::to_string(epoxy_gl_version() / 10) +
                             "." + std::to_string(epoxy_gl_version() % 10));
  }
  impl_ = std::make_unique<Impl>();
}

Renderer::~Renderer() = default;

void Renderer::draw(const Scene& scene, const Camera& camera, const Style& style, const Target& target) {
  Impl& r = *impl_;
  const int samples = style.plain ? 1 : style.samples;
  if (!r.layers || r.layers->width != target.width || r.layers->height != target.height ||
      r.layers->samples != samples || r.layers->plain != style.plain) {
    r.layers.emplace(target.width, target.height, samples, style.plain);
  }
  if (!r.shadow_map || r.shadow_map->texels != style.shadow_texels) r.shadow_map.emplace(style.shadow_texels);
  const Focus focus = focus_of(scene);
  r.share(make_frame(scene, focus, camera, double(target.width) / target.height, style.shadow_texels));
  r.bodies.place(scene, camera.eye, style);
  r.boxes.place(scene, camera.eye, style);
  r.marks.place(scene, camera.eye, style);
  glEnable(GL_CULL_FACE);
  r.draw_shadows();
  r.draw_solids(scene, camera, focus, style);
  if (style.occlusion && !style.plain) r.draw_occlusion();
  r.draw_over(scene, camera, focus);
  if (style.boxes || style.cells) r.draw_boxes();
  if (style.contacts || style.joints || style.forces || style.axes) r.draw_marks();
  r.finish(style, target);
}

IdImage Renderer::ids(const Scene& scene, const Camera& camera, int width, int height) {
  Impl& r = *impl_;
  const gl::Texture seen = gl::make_texture(gl::id_format, width, height, GL_NEAREST);
  const gl::Texture depth = gl::make_texture(gl::depth_format, width, height, GL_NEAREST);
  const gl::Framebuffer framebuffer = gl::make_framebuffer(seen, depth);
  r.share(make_frame(scene, focus_of(scene), camera, double(width) / height, 1));
  r.bodies.place(scene, camera.eye, {});
  begin_pass(framebuffer, width, height, true);
  const GLuint nothing[4] = {0, 0, 0, 0};
  glClearBufferuiv(GL_COLOR, 0, nothing);
  glClear(GL_DEPTH_BUFFER_BIT);
  r.id.use();
  r.bodies.draw();
  IdImage image{width, height, std::vector<std::uint32_t>(std::size_t(width) * std::size_t(height))};
  std::vector<std::uint32_t> upside_down(image.ids.size());
  glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, upside_down.data());
  for (int y = 0; y < height; ++y) {
    std::copy_n(&upside_down[std::size_t((height - 1 - y) * width)], width, &image.ids[std::size_t(y * width)]);
  }
  return image;
}

}
