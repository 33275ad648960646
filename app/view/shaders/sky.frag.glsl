in vec2 screen;
out vec4 light;

void main() {
  vec4 far = inverse_view_projection * vec4(screen * 2.0 - 1.0, 1.0, 1.0);
  light = shown(vec4(sky(normalize(far.xyz / far.w)), 0.0));
}
