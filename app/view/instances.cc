#include "view/instances.h"

#include <algorithm>
#include <cstddef>

namespace sudar::view {

namespace {

// `place` and `offset` as in shaders/body.vert.glsl.
void float_attribute(GLuint place, GLint size, std::size_t stride, std::size_t offset) {
  glEnableVertexAttribArray(place);
  glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, GLsizei(stride), reinterpret_cast<const void*>(offset));
}

// The attributes of the copies from number `first` on. (OpenGL 3.3 has no first instance in its draw calls.)
void point_at_instances(std::size_t first) {
  const std::size_t base = first * sizeof(GpuInstance), stride = sizeof(GpuInstance);
  float_attribute(4, 3, stride, base + offsetof(GpuInstance, position));
  float_attribute(5, 4, stride, base + offsetof(GpuInstance, turn));
  float_attribute(6, 3, stride, base + offsetof(GpuInstance, scale));
  float_attribute(7, 3, stride, base + offsetof(GpuInstance, colour));
  float_attribute(8, 2, stride, base + offsetof(GpuInstance, contrast));
  glEnableVertexAttribArray(9);
  glVertexAttribIPointer(9, 1, GL_UNSIGNED_INT, GLsizei(stride),
                         reinterpret_cast<const void*>(base + offsetof(GpuInstance, id)));
  for (GLuint place = 4; place <= 9; ++place) glVertexAttribDivisor(place, 1);
}

}

std::size_t Instances::add_mesh(const Mesh& mesh) {
  OnCard m{
      gl::make_vertex_array(),      gl::make_buffer(), gl::make_buffer(), GLenum(mesh.lines ? GL_LINES : GL_TRIANGLES),
      GLsizei(mesh.indices.size()), meshes_.size()};
  glBindVertexArray(m.layout);
  glBindBuffer(GL_ARRAY_BUFFER, m.vertices);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(MeshVertex)), mesh.vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m.indices);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(mesh.indices.size() * sizeof(std::uint32_t)), mesh.indices.data(),
               GL_STATIC_DRAW);
  float_attribute(0, 3, sizeof(MeshVertex), offsetof(MeshVertex, position));
  float_attribute(1, 3, sizeof(MeshVertex), offsetof(MeshVertex, normal));
  float_attribute(2, 3, sizeof(MeshVertex), offsetof(MeshVertex, edge_normal));
  float_attribute(3, 2, sizeof(MeshVertex), offsetof(MeshVertex, edge));
  meshes_.push_back(std::move(m));
  return meshes_.size() - 1;
}

std::size_t Instances::add_mesh(const Mesh& mesh, const Mesh& plainer) {
  const std::size_t number = add_mesh(plainer), own = add_mesh(mesh);
  meshes_[own].plainer = number;
  return own;
}

std::vector<Instances::Batch> Instances::append(const Copies& copies_of_mesh, std::vector<GpuInstance>& all) {
  std::vector<Batch> batches;
  for (std::size_t mesh = 0; mesh < copies_of_mesh.size(); ++mesh) {
    const auto& copies = copies_of_mesh[mesh];
    if (!copies.empty()) batches.push_back({mesh, all.size(), copies.size()});
    all.insert(all.end(), copies.begin(), copies.end());
  }
  const auto nearest = [&](const Batch& b) { return length_squared(all[b.first].position); };
  std::stable_sort(batches.begin(), batches.end(),
                   [&](const Batch& a, const Batch& b) { return nearest(a) < nearest(b); });
  return batches;
}

void Instances::place(const Copies& copies_of_mesh, const Copies& translucent) {
  std::vector<GpuInstance> all;
  batches_ = append(copies_of_mesh, all);
  translucent_ = append(translucent, all);
  glBindBuffer(GL_ARRAY_BUFFER, instances_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(all.size() * sizeof(GpuInstance)), all.data(), GL_STREAM_DRAW);
}

void Instances::draw(const std::vector<Batch>& batches, Detail detail) const {
  for (const Batch& batch : batches) {
    const OnCard& mesh = meshes_[detail == Detail::full ? batch.mesh : plainer(batch.mesh)];
    glBindVertexArray(mesh.layout);
    glBindBuffer(GL_ARRAY_BUFFER, instances_);
    point_at_instances(batch.first);
    glDrawElementsInstanced(mesh.primitive, mesh.count, GL_UNSIGNED_INT, nullptr, GLsizei(batch.count));
  }
}

void Instances::draw(Detail detail) const { draw(batches_, detail); }

void Instances::draw_translucent() const { draw(translucent_, Detail::full); }

}
