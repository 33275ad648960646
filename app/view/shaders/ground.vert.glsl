// A half space: a large square of its surface, round the point below the camera.
uniform vec3 centre;      // of the square, relative to the eye
uniform vec3 side_x, side_z;  // unit vectors of the surface
uniform float reach;      // half its edge, m
out vec3 at;
out vec2 place;           // in the surface, from the square's centre, m

void main() {
  place = reach * vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1);
  at = centre + side_x * place.x + side_z * place.y;
  gl_Position = view_projection * vec4(at, 1.0);
}
