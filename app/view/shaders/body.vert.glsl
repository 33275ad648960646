// One vertex of one instance. The same shader places bodies for the picture, the shadow map and the picture of ids.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 edge_normal;
layout(location = 3) in vec2 edge_and_tone;
layout(location = 4) in vec3 instance_position;
layout(location = 5) in vec4 instance_turn;
layout(location = 6) in vec3 instance_scale;
layout(location = 7) in vec3 instance_colour;
layout(location = 8) in vec2 instance_contrast_and_gloss;
layout(location = 9) in uint instance_id;

uniform bool from_sun;

out vec3 at;
out vec3 face_normal;
out vec3 rounded_normal;
out float from_edge;
flat out vec3 albedo;
flat out float gloss;
flat out uint id;

vec3 turned(vec4 q, vec3 v) {
  vec3 t = 2.0 * cross(q.xyz, v);
  return v + q.w * t + cross(q.xyz, t);
}

void main() {
  at = instance_position + turned(instance_turn, instance_scale * position);
  face_normal = turned(instance_turn, normal / instance_scale);
  rounded_normal = turned(instance_turn, edge_normal / instance_scale);
  from_edge = edge_and_tone.x;
  const vec3 second = vec3(0.86, 0.84, 0.80);  // tone, in full contrast
  albedo = mix(instance_colour, second, instance_contrast_and_gloss.x * edge_and_tone.y);
  gloss = instance_contrast_and_gloss.y;
  id = instance_id;
  gl_Position = (from_sun ? sun_projection : view_projection) * vec4(at, 1.0);
}
