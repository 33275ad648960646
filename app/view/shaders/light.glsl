// Light of a clear afternoon, in linear units: a warm sun with a soft shadow, a blue sky, and light thrown up by the
// ground.
uniform sampler2DShadow shadow_map;

const vec3 sun_light = vec3(1.00, 0.91, 0.78) * 1.60;
const vec3 sky_light = vec3(0.64, 0.78, 1.00) * 0.62;
const vec3 ground_light = vec3(0.50, 0.46, 0.42) * 0.50;
const vec3 horizon = vec3(0.62, 0.73, 0.83);
const vec3 nadir = vec3(0.36, 0.37, 0.38);
const vec3 zenith = vec3(0.13, 0.30, 0.60);

// A wide halo and a narrow one.
vec3 sun_halo(vec3 direction) {
  float s = max(dot(direction, sun.xyz), 0.0), s2 = s * s, s4 = s2 * s2, s8 = s4 * s4, s32 = s8 * s8 * s8 * s8;
  return sun_light * (0.06 * s4 * s2 + 0.10 * s32 * s32);
}

vec3 sky(vec3 direction) {
  float up = clamp(direction.y, 0.0, 1.0);
  vec3 colour = mix(horizon, zenith, mix(up, sqrt(up), 0.76));
  colour = mix(colour, nadir, smoothstep(0.0, 0.5, -direction.y));  // what is seen where there is no floor
  return colour + sun_halo(direction);
}

// A different angle for each pixel of a small tile, as even as can be: interleaved gradient noise (Jimenez 2014).
float pixel_noise(vec2 pixel) { return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))); }

// Share of the sun that is seen by a surface that faces it, 0…1: percentage-closer filtering (Reeves et al. 1987) over a
// disk of the shadow map, its samples on Vogel's spiral from the rim inwards; where the outer half of many agrees, so
// does the rest. The number of samples is not known beforehand: a processor that draws works on some pixels at once, and leaves a
// loop when the last of them does, but goes through both ways of a branch.
float sunlight(vec3 position, vec3 normal, float facing) {
  const int samples = SHADOW_SAMPLES;
  const float softness = 2.6;  // radius of the disk in texels
  const mat2 golden_turn = mat2(-0.737369, 0.675490, -0.675490, -0.737369);
  vec3 lifted = position + normal * sun.w * (4.7 - 3.5 * facing);  // off the surface, or it shadows itself
  vec3 place = (sun_projection * vec4(lifted, 1.0)).xyz * 0.5 + 0.5;
  vec3 inside = 0.5 - abs(place - 0.5);
  float border = min(inside.x, inside.y);
#ifdef PLAIN
  float turn = 0.7;  // the bilinear filter of few samples is smooth enough; noise would be seen
#else
  float turn = 6.2831853 * pixel_noise(gl_FragCoord.xy);
#endif
  vec2 way = softness * zoom.z * vec2(cos(turn), sin(turn));
  float seen = 0.0;
  for (int i = facing > 0.0 && min(border, inside.z) >= 0.0 ? samples - 1 : -1; i >= 0; --i) {
    seen += textureLod(shadow_map, vec3(place.xy + sqrt((float(i) + 0.5) / float(samples)) * way, place.z), 0.0);
    way = golden_turn * way;
#ifndef PLAIN
    if (i == samples / 2 && (seen == 0.0 || seen == float(samples / 2))) {
      seen *= 2.0;
      break;
    }
#endif
  }
  // Shadows of what reaches out of the map end softly.
  return mix(1.0, seen / float(samples), inside.z >= 0.0 ? smoothstep(0.0, 0.06, border) : 0.0);
}

float fifth_power(float x) {
  float x2 = x * x;
  return x2 * x2 * x;
}

// Light from a surface to the eye. Alpha: the share of it that is ambient, which ambient occlusion may take away.
vec4 shade(vec3 albedo, vec3 position, vec3 normal, float gloss) {
  vec3 to_eye = normalize(-position);
  float facing = dot(normal, sun.xyz);
  float lit = max(facing, 0.0) * sunlight(position, normal, facing);
  vec3 ambient = albedo * mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
  vec3 half_way = normalize(to_eye + sun.xyz);
  float fresnel = 0.04 + 0.96 * fifth_power(1.0 - max(dot(to_eye, half_way), 0.0));
  float h = max(dot(normal, half_way), 0.0), h2 = h * h, h4 = h2 * h2, h8 = h4 * h4, h16 = h8 * h8;
  float highlight = gloss * fresnel * 9.0 * h16 * h16 * h16 * h8;
#ifdef PLAIN
  vec3 reflected = vec3(0.0);
#else
  vec3 reflected =
      gloss * sky(reflect(-to_eye, normal)) * (0.02 + 0.35 * fifth_power(1.0 - max(dot(normal, to_eye), 0.0)));
#endif
  vec3 direct = sun_light * lit * (albedo + highlight);
  vec3 total = ambient + direct + reflected;
  const vec3 luminance = vec3(0.2126, 0.7152, 0.0722);
  return vec4(total, dot(ambient + reflected, luminance) / max(dot(total, luminance), 1e-4));
}
