// A picture in one step, for slow machines: shaders write the final colours. After tone.glsl.
#define PLAIN
#define SHADOW_SAMPLES 4

// sRGB's curve as a polynomial of the root: within 0.4 of 255 levels from level 14 up, within 1.5 below.
vec3 quick_srgb(vec3 c) {
  vec3 s = sqrt(max(c, 0.0));
  return s * (1.33144 + s * (0.18724 * s - 0.48877)) - 0.02854;
}

vec4 shown(vec4 light) { return vec4(quick_srgb(tone_mapped(light.rgb)), light.a); }
