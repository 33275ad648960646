// What the renderer draws into on its way to a picture.
#pragma once

#include "view/gl.h"

namespace sudar::view {

// What a picture of one size is drawn into before it is finished.
struct Layers {
  int width, height, samples;
  bool plain;
  gl::Texture light, depth, mark_depth, occlusion;
  gl::Framebuffer framebuffer, mark_framebuffer, occlusion_framebuffer;

  Layers(int w, int h, int s, bool p)
      : width(w),
        height(h),
        samples(s),
        plain(p),
        light(gl::make_texture(p ? gl::picture_format : gl::hdr_format, w * s, h * s, GL_NEAREST)),
        depth(gl::make_texture(gl::depth_format, w * s, h * s, GL_NEAREST)),
        mark_depth(gl::make_texture(gl::depth_format, w * s, h * s, GL_NEAREST)),
        occlusion(gl::make_texture(gl::grey_format, w, h, GL_NEAREST)),
        framebuffer(gl::make_framebuffer(light, depth)),
        mark_framebuffer(gl::make_framebuffer(light, mark_depth)),
        occlusion_framebuffer(gl::make_framebuffer(occlusion, 0)) {}
};

struct ShadowMap {
  int texels;
  gl::Texture depth;
  gl::Framebuffer framebuffer;

  explicit ShadowMap(int size)
      : texels(size),
        depth(gl::make_texture(gl::depth_format, size, size, GL_LINEAR)),
        framebuffer(gl::make_framebuffer(0, depth)) {
    glBindTexture(GL_TEXTURE_2D, depth);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  }
};

}
