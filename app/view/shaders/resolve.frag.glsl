// From light to a picture: ambient occlusion, tone mapping, the mean of the samples of a pixel, sRGB.
uniform sampler2D light_map;
uniform sampler2D occlusion;
uniform sampler2D depth;
uniform int samples;        // per pixel along each side
uniform bool occluded;      // is there an occlusion map?
out vec4 colour;

float depth_at(ivec2 pixel) { return texelFetch(depth, pixel * samples + samples / 2, 0).x; }

// Mean of the 4 × 4 pixels over which the occlusion's samples are turned, as far as they lie at about the same depth.
float openness() {
  if (!occluded) return 1.0;
  ivec2 here = ivec2(gl_FragCoord.xy), last = textureSize(occlusion, 0) - 1;
  float depth_here = depth_at(here), sum = 0.0, weights = 1e-4;
  float tolerance = 0.015 * (1.0 - depth_here) + 1e-7;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 there = clamp(here + ivec2(x, y), ivec2(0), last);
      float weight = abs(depth_at(there) - depth_here) < tolerance ? 1.0 : 0.02;
      sum += weight * texelFetch(occlusion, there, 0).x;
      weights += weight;
    }
  }
  return sum / weights;
}

void main() {
  float open = openness();
  ivec2 corner = ivec2(gl_FragCoord.xy) * samples;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < samples; ++y) {
    for (int x = 0; x < samples; ++x) {
      vec4 light = texelFetch(light_map, corner + ivec2(x, y), 0);
      sum += tone_mapped(light.rgb * (1.0 - light.a * (1.0 - open)));
    }
  }
  // Half a step of noise hides the bands of the sky.
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(srgb(sum / float(samples * samples)) + noise / 255.0, 1.0);
}
