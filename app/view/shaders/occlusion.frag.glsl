// Ambient occlusion from the depth buffer: how much of the sky the nearby surfaces hide, by the estimator of McGuire et
// al. 2011 (Alchemy screen-space ambient obscurance).
uniform sampler2D depth;
in vec2 screen;
out float open;

vec3 position(vec2 where) {
  vec4 p = inverse_view_projection * vec4(vec3(where, textureLod(depth, where, 0.0).x) * 2.0 - 1.0, 1.0);
  return p.xyz / p.w;
}

// Of the two neighbours the one on the same surface, so that normals are right up to the edges.
vec3 tangent(vec3 p, vec2 step) {
  vec3 forth = position(screen + step) - p, back = p - position(screen - step);
  return dot(forth, forth) < dot(back, back) ? forth : back;
}

void main() {
  const int samples = 11;
  if (textureLod(depth, screen, 0.0).x >= 1.0) {
    open = 1.0;
    return;
  }
  vec2 texel = 1.0 / vec2(textureSize(depth, 0));
  vec3 p = position(screen);
  vec3 normal = normalize(cross(tangent(p, vec2(texel.x, 0.0)), tangent(p, vec2(0.0, texel.y))));
  float radius = scale.w;
  vec2 on_screen = min(0.5 * radius * zoom.xy / (view_projection * vec4(p, 1.0)).w, vec2(0.2));
  float turn = 6.2831853 * fract(dot(floor(mod(gl_FragCoord.xy, 4.0)), vec2(0.25, 0.0625)));
  float hidden = 0.0;
  for (int i = 0; i < samples; ++i) {
    float share = (float(i) + 0.5) / float(samples), angle = 2.3999632 * float(i) + turn;
    vec3 towards = position(screen + on_screen * share * vec2(cos(angle), sin(angle))) - p;
    float squared = dot(towards, towards), within = max(1.0 - squared / (radius * radius), 0.0);
    hidden += within * max(dot(towards, normal) - 0.002 * length(p), 0.0) / (squared + 0.01 * radius * radius) * radius;
  }
  open = clamp(1.0 - 0.55 * hidden / float(samples), 0.0, 1.0);
}
