#include "view/gl.h"

#include <stdexcept>

#include "view/shaders.h"

namespace sudar::view::gl {

namespace {

struct Shader {
  GLuint id;
  explicit Shader(GLenum kind) : id(glCreateShader(kind)) {}
  ~Shader() { glDeleteShader(id); }
  Shader(const Shader&) = delete;
};

void compile(const Shader& shader, const std::vector<std::string>& files) {
  std::string text = "#version 330 core\n", names;
  for (const std::string& file : files) {
    text += shader_text(file);
    names += (names.empty() ? "" : " + ") + file;
  }
  const char* source = text.c_str();
  glShaderSource(shader.id, 1, &source, nullptr);
  glCompileShader(shader.id);
  GLint ok = 0;
  glGetShaderiv(shader.id, GL_COMPILE_STATUS, &ok);
  if (ok) return;
  char log[4096] = "";
  glGetShaderInfoLog(shader.id, sizeof log, nullptr, log);
  throw std::runtime_error("shader " + names + ": " + log);
}

}

Buffer make_buffer() {
  GLuint id = 0;
  glGenBuffers(1, &id);
  return Buffer(id);
}

VertexArray make_vertex_array() {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  return VertexArray(id);
}

Texture make_texture(const TextureFormat& f, int width, int height, GLint filter) {
  GLuint id = 0;
  glGenTextures(1, &id);
  glBindTexture(GL_TEXTURE_2D, id);
  glTexImage2D(GL_TEXTURE_2D, 0, f.internal, width, height, 0, f.format, f.type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return Texture(id);
}

Framebuffer make_framebuffer(GLuint colour_texture, GLuint depth_texture) {
  GLuint id = 0;
  glGenFramebuffers(1, &id);
  Framebuffer made(id);
  glBindFramebuffer(GL_FRAMEBUFFER, id);
  if (colour_texture) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, colour_texture, 0);
  if (depth_texture) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_texture, 0);
  const GLenum drawn = colour_texture ? GL_COLOR_ATTACHMENT0 : GL_NONE;
  glDrawBuffers(1, &drawn);
  glReadBuffer(drawn);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL: the driver refuses a framebuffer of a format that 3.3 demands");
  }
  return made;
}

Program::Program(const std::vector<std::string>& vertex_files, const std::vector<std::string>& fragment_files)
    : program_(glCreateProgram()) {
  const Shader vertex(GL_VERTEX_SHADER), fragment(GL_FRAGMENT_SHADER);
  compile(vertex, vertex_files);
  compile(fragment, fragment_files);
  glAttachShader(program_, vertex.id);
  glAttachShader(program_, fragment.id);
  glLinkProgram(program_);
  GLint ok = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &ok);
  if (ok) return;
  char log[4096] = "";
  glGetProgramInfoLog(program_, sizeof log, nullptr, log);
  throw std::runtime_error("shaders " + vertex_files.back() + " and " + fragment_files.back() + ": " + log);
}

}
