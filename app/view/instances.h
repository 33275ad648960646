// Many copies of few meshes, on the graphics card: one draw call per mesh.
#pragma once

#include "view/gl.h"
#include "view/mesh.h"

namespace sudar::view {

struct GpuInstance {
  Vec3f position;  // relative to the eye
  Vec4f turn{};    // quaternion x, y, z, w
  Vec3f scale{1, 1, 1};
  Vec3f colour;        // linear
  float contrast = 0;  // of the second tone
  float gloss = 0;
  std::uint32_t id = 0;
};

class Instances {
 public:
  std::size_t add_mesh(const Mesh&);  // returns its number
  // With a plainer one for where details are not seen: in the shadow map, and far away.
  std::size_t add_mesh(const Mesh&, const Mesh& plainer);
  std::size_t plainer(std::size_t mesh) const { return meshes_[mesh].plainer; }  // itself where there is none
  std::size_t meshes() const { return meshes_.size(); }
  // What draw() draws until the next call: for every mesh its copies; and what draw_translucent() draws. May be shorter
  // than the list of meshes.
  using Copies = std::vector<std::vector<GpuInstance>>;
  void place(const Copies& copies_of_mesh, const Copies& translucent = {});
  enum class Detail { full, plainer };
  void draw(Detail = Detail::full) const;  // with the program in use
  void draw_translucent() const;
  bool any_translucent() const { return !translucent_.empty(); }

 private:
  struct OnCard {
    gl::VertexArray layout;
    gl::Buffer vertices, indices;
    GLenum primitive;
    GLsizei count;
    std::size_t plainer;
  };
  struct Batch {
    std::size_t mesh, first, count;
  };
  static std::vector<Batch> append(const Copies&, std::vector<GpuInstance>& all);
  void draw(const std::vector<Batch>&, Detail) const;
  std::vector<OnCard> meshes_;
  gl::Buffer instances_ = gl::make_buffer();
  std::vector<Batch> batches_, translucent_;
};

}
