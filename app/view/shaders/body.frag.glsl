in vec3 at;
in vec3 face_normal;
in vec3 rounded_normal;
in float from_edge;
flat in vec3 albedo;
flat in float gloss;

out vec4 light;

void main() {
  // Rounded edges: near an edge the normal leans over to the middle between the two faces. Where the rounding is
  // smaller than a pixel it would only flicker, so it fades.
  float flatness = mix(smoothstep(0.0, 1.0, from_edge), 1.0, smoothstep(0.7, 2.5, fwidth(from_edge)));
  // Two normals that differ are those of a hull, constant over a triangle and of length 1.
  vec3 normal = normalize(mix(rounded_normal, face_normal, flatness));
  light = shown(shade(albedo, at, normal, gloss));
}
