// One triangle over the whole picture.
out vec2 screen;  // 0…1

void main() {
  screen = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(screen * 2.0 - 1.0, 1.0, 1.0);
}
