// Bodies of another run, translucent over the picture: in their own colour, fuller where the surface turns away.
in vec3 at;
in vec3 face_normal;
flat in vec3 albedo;

out vec4 light;

void main() {
  float facing = abs(dot(normalize(face_normal), normalize(-at)));
  light = shown(vec4(mix(albedo, vec3(0.7, 0.8, 1.0), 0.5) * 0.9, mix(0.6, 0.28, facing)));
}
