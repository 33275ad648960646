// A picture in one step, for slow machines: shaders write the final colours. After tone.glsl.
#define PLAIN
#define SHADOW_SAMPLES 4

vec4 shown(vec4 light) { return vec4(srgb(tone_mapped(light.rgb)), light.a); }
