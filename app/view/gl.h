// OpenGL 3.3 core objects that free themselves. No context code: whoever draws has made one current, and keeps it so
// until these objects are gone.
#pragma once

#include <epoxy/gl.h>

#include <string>
#include <utility>
#include <vector>

#include "view/linear.h"

namespace sudar::view::gl {

// The name of an object; 0 is none.
template <void (*Destroy)(GLuint)>
class Name {
 public:
  Name() = default;
  explicit Name(GLuint id) : id_(id) {}
  Name(Name&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Name& operator=(Name&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Name() {
    if (id_ != 0) Destroy(id_);
  }
  operator GLuint() const { return id_; }

 private:
  GLuint id_ = 0;
};
inline void destroy_buffer(GLuint id) { glDeleteBuffers(1, &id); }
inline void destroy_vertex_array(GLuint id) { glDeleteVertexArrays(1, &id); }
inline void destroy_texture(GLuint id) { glDeleteTextures(1, &id); }
inline void destroy_framebuffer(GLuint id) { glDeleteFramebuffers(1, &id); }
inline void destroy_program(GLuint id) { glDeleteProgram(id); }
using Buffer = Name<destroy_buffer>;
using VertexArray = Name<destroy_vertex_array>;
using Texture = Name<destroy_texture>;
using Framebuffer = Name<destroy_framebuffer>;

Buffer make_buffer();
VertexArray make_vertex_array();

struct TextureFormat {
  GLint internal;
  GLenum format, type;
};
inline constexpr TextureFormat hdr_format{GL_RGBA16F, GL_RGBA, GL_FLOAT};
inline constexpr TextureFormat picture_format{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
inline constexpr TextureFormat grey_format{GL_R8, GL_RED, GL_UNSIGNED_BYTE};
inline constexpr TextureFormat id_format{GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
inline constexpr TextureFormat depth_format{GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
// `filter`: GL_NEAREST or GL_LINEAR. Clamped at the edges.
Texture make_texture(const TextureFormat&, int width, int height, GLint filter);

// Throws std::runtime_error when the driver does not take it. 0 for what is not there.
Framebuffer make_framebuffer(GLuint colour_texture, GLuint depth_texture);

// A vertex and a fragment shader, linked. Each is the concatenation of shader files by name (view/shaders), so that
// common parts are written once.
class Program {
 public:
  Program(const std::vector<std::string>& vertex_files, const std::vector<std::string>& fragment_files);
  void use() const { glUseProgram(program_); }
  void bind_block(const char* block, GLuint binding) const {
    const GLuint index = glGetUniformBlockIndex(program_, block);
    if (index != GL_INVALID_INDEX) glUniformBlockBinding(program_, index, binding);
  }
  // A uniform that the program does not have is left alone.
  void set(const char* uniform, int value) const { glUniform1i(place(uniform), value); }
  void set(const char* uniform, float value) const { glUniform1f(place(uniform), value); }
  void set(const char* uniform, float x, float y) const { glUniform2f(place(uniform), x, y); }
  void set(const char* uniform, const Vec3f& v) const { glUniform3f(place(uniform), v.x, v.y, v.z); }

 private:
  GLint place(const char* uniform) const { return glGetUniformLocation(program_, uniform); }
  Name<destroy_program> program_;
};

inline std::vector<std::string> joined(std::vector<std::string> files, const char* last) {
  files.push_back(last);
  return files;
}

// Binds the texture to a unit.
inline void bind(int unit, GLuint texture) {
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

}
