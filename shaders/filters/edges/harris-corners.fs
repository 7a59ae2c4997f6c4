/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Marks corners, which trackers can hold on to",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sensitivity", "TYPE": "float", "LABEL": "Sensitivity", "DEFAULT": 0.5, "MIN": 0, "MAX": 2}
  ],
  "PASSES": [
    {"TARGET": "response", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 10,
    "SAMPLING": "nearest",
    "TOOLTIP": {"sensitivity": "More marks more corners"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

// Harris and Stephens 1988: det(M) - k trace(M)^2 of the gradients around.
vec2 slope(vec2 d) {
  vec2 p = gl_FragCoord.xy + d;
  return 0.5 * vec2(grey(IMG_PIXEL(inputImage, p + vec2(1, 0)).rgb) - grey(IMG_PIXEL(inputImage, p - vec2(1, 0)).rgb),
                    grey(IMG_PIXEL(inputImage, p + vec2(0, 1)).rgb) - grey(IMG_PIXEL(inputImage, p - vec2(0, 1)).rgb));
}
void main() {
  if (PASSINDEX == 0) {
    vec3 m = vec3(0.0);
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) {
        vec2 g = slope(vec2(x, y));
        m += exp(-0.25 * float(x * x + y * y)) * vec3(g.x * g.x, g.y * g.y, g.x * g.y);
      }
    float trace = m.x + m.y;
    gl_FragColor = vec4(m.x * m.y - m.z * m.z - 0.05 * trace * trace);
    return;
  }
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float here = IMG_THIS_PIXEL(response).r, best = 0.0;
  vec2 at = vec2(100.0);
  for (int y = -5; y <= 5; ++y)
    for (int x = -5; x <= 5; ++x) {
      float v = IMG_PIXEL(response, gl_FragCoord.xy + vec2(x, y)).r;
      if (v > best) {
        best = v;
        at = vec2(x, y);
      }
    }
  float limit = 1e-3 * pow(10.0, -2.0 * sensitivity);
  float ring = best > limit && length(at) > 1.5 && length(at) < 4.5 ? 1.0 : 0.0;
  vec3 base = mix(vec3(grey(c.rgb)) * 0.6, c.rgb, 0.4);
  gl_FragColor = vec4(mix(base, vec3(1.0, 0.8, 0.1), ring), c.a);
}
