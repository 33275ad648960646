// Ambient occlusion from the depth buffer: how much of the sky the nearby surfaces hide, by the estimator of McGuire et
// al. 2011 (Alchemy screen-space ambient obscurance).
uniform sampler2D depth;
in vec2 screen;
out float open;

// By whole texels: a place between two of them would take the depth of one or the other, as rounding has it, and show
// as hatching where a surface is seen at a flat angle.
vec3 position(ivec2 texel) {
  ivec2 size = textureSize(depth, 0);
  texel = clamp(texel, ivec2(0), size - 1);
  vec3 place = vec3((vec2(texel) + 0.5) / vec2(size), texelFetch(depth, texel, 0).x);
  vec4 p = inverse_view_projection * vec4(place * 2.0 - 1.0, 1.0);
  return p.xyz / p.w;
}

// Of the two neighbours the one on the same surface, so that normals are right up to the edges.
vec3 tangent(vec3 p, ivec2 here, ivec2 step) {
  vec3 forth = position(here + step) - p, back = p - position(here - step);
  return dot(forth, forth) < dot(back, back) ? forth : back;
}

void main() {
  const int samples = 11;
  vec2 size = vec2(textureSize(depth, 0));
  ivec2 here = ivec2(screen * size + 0.25);  // the middle of a pixel is a corner of texels if it has 2 × 2 of them
  if (texelFetch(depth, here, 0).x >= 1.0) {
    open = 1.0;
    return;
  }
  vec3 p = position(here);
  vec3 normal = normalize(cross(tangent(p, here, ivec2(1, 0)), tangent(p, here, ivec2(0, 1))));
  float radius = scale.w;
  vec2 on_screen = min(0.5 * radius * zoom.xy / (view_projection * vec4(p, 1.0)).w, vec2(0.2));
  float turn = 6.2831853 * fract(dot(floor(mod(gl_FragCoord.xy, 4.0)), vec2(0.25, 0.0625)));
  float hidden = 0.0;
  for (int i = 0; i < samples; ++i) {
    float share = (float(i) + 0.5) / float(samples), angle = 2.3999632 * float(i) + turn;
    vec2 offset = on_screen * share * vec2(cos(angle), sin(angle));
    vec3 towards = position(here + ivec2(round(offset * size))) - p;
    float squared = dot(towards, towards), within = max(1.0 - squared / (radius * radius), 0.0);
    hidden += within * max(dot(towards, normal) - 0.002 * length(p), 0.0) / (squared + 0.01 * radius * radius) * radius;
  }
  open = clamp(1.0 - 0.55 * hidden / float(samples), 0.0, 1.0);
}
