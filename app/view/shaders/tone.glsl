// From light to what a screen shows.

// Leaves colours as they are up to 0.8, then bends to white and takes the saturation with it: the tone mapper "PBR
// Neutral" (Khronos 2024).
vec3 tone_mapped(vec3 c) {
  const float start = 0.76, desaturation = 0.15;
  float x = min(c.r, min(c.g, c.b));
  c -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < start) return c;
  float d = 1.0 - start, bent = 1.0 - d * d / (peak + d - start);
  c *= bent / peak;
  return mix(c, vec3(bent), 1.0 - 1.0 / (desaturation * (peak - bent) + 1.0));
}

vec3 srgb(vec3 c) { return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)); }
