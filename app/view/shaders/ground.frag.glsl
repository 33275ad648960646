// Floors are solid and fade into the horizon; walls are panes of faint glass round the scene.
uniform vec3 normal;
uniform vec2 offset;        // of the square's centre from a crossing of the coarse grid, m
uniform float cell;         // edge of a cell of the fine grid, m; ten make a coarse one
uniform vec3 scene_centre;  // relative to the eye
uniform float scene_radius;
in vec3 at;
in vec2 place;
out vec4 light;

// Share of the pixel that grid lines of the given width (in cells) cover: the integral of the line pattern over the
// pixel's footprint, so that far lines fade to their mean instead of flickering.
float coverage(vec2 x, vec2 footprint, float width) {
  vec2 f = max(footprint, 1e-6);
  vec2 from = x - 0.5 * f + 0.5 * width, to = from + f;
  vec2 covered = (floor(to) * width + min(fract(to), width)) - (floor(from) * width + min(fract(from), width));
  vec2 share = clamp(covered / f, 0.0, 1.0);
  return share.x + share.y - share.x * share.y;
}

void main() {
  vec2 x = (place + offset) / cell;
  vec2 footprint = fwidth(x);
  float fine = coverage(x, footprint, 0.022) * (1.0 - smoothstep(0.15, 0.6, max(footprint.x, footprint.y)));
  float coarse = coverage(x * 0.1, footprint * 0.1, 0.0045);
  float line = max(0.45 * fine, 0.85 * coarse);
#ifdef GLASS
  float near = 1.0 - smoothstep(0.7, 1.6, length(at - scene_centre) / scene_radius);
  light = shown(vec4(mix(vec3(0.75, 0.85, 0.95), vec3(0.25, 0.32, 0.4), line), near * mix(0.10, 0.45, line)));
#else
  vec3 albedo = mix(vec3(0.43, 0.435, 0.43), vec3(0.20, 0.215, 0.24), line);
  vec4 surface = shade(albedo, at, normal, 0.25);
  float distance = length(at) / scale.z, far = 1.0 - exp(-distance * sqrt(distance));
  light = shown(vec4(mix(surface.rgb, horizon + sun_halo(normalize(vec3(at.x, 0.0, at.z))), far), surface.a * (1.0 - far)));
#endif
}
