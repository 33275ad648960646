// What all shaders of one picture share. Positions are relative to the eye, in world axes.
layout(std140) uniform Frame {
  mat4 view_projection;
  mat4 inverse_view_projection;
  mat4 sun_projection;   // → the shadow map, −1…1
  vec4 sun;              // xyz: unit vector towards the sun; w: size of a texel of the shadow map, m
  vec4 scale;            // near plane, far plane, distance at which the ground has faded into the horizon, radius of ambient occlusion; m
  vec4 zoom;             // xy: 1 / tangent of half the picture's angle across and up; z: 1 / texels along the shadow map's edge
};
