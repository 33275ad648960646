// Contact points, normals, joints: drawn over everything, in their own colour with just enough shading to look round.
in vec3 at;
in vec3 face_normal;
flat in vec3 albedo;

out vec4 light;

void main() {
  light = shown(vec4(albedo * (0.65 + 0.5 * max(dot(normalize(face_normal), normalize(-at)), 0.0)), 0.0));
}
