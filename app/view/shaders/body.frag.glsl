in vec3 at;
in vec3 face_normal;
in vec3 rounded_normal;
in vec2 edge_tone;
flat in vec3 colour;
flat in vec2 contrast_gloss;

out vec4 light;

void main() {
  // Rounded edges: near an edge the normal leans over to the middle between the two faces. Where the rounding is
  // smaller than a pixel it would only flicker, so it fades.
  float width = fwidth(edge_tone.x);
  float flatness = mix(smoothstep(0.0, 1.0, edge_tone.x), 1.0, smoothstep(0.7, 2.5, width));
  vec3 normal = normalize(mix(normalize(rounded_normal), normalize(face_normal), flatness));
  vec3 second = mix(colour, vec3(0.86, 0.84, 0.80), contrast_gloss.x);
  vec3 albedo = mix(colour, second, edge_tone.y);
  light = shown(shade(albedo, at, normal, contrast_gloss.y));
}
