/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Smooths surfaces and keeps edges: takes noise out",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 5, "MIN": 0.5, "MAX": 20},
    {"NAME": "range", "TYPE": "float", "LABEL": "Range", "DEFAULT": 0.1, "MIN": 0.01, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "6 * max(1, floor($sigma * $WIDTH / 5760 + 0.5))",
    "SAMPLING": "nearest",
    "UNIT": {"sigma": "px of 1920", "range": "of white"},
    "TOOLTIP": {"sigma": "How far it smooths", "range": "How different a neighbour may be"}
  }
}*/
// Tomasi and Manduchi 1998, on a 13 x 13 window.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float s = sigma * RENDERSIZE.x / 1920.0;
  float spacing = max(1.0, floor(s / 3.0 + 0.5));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int y = -6; y <= 6; ++y)
    for (int x = -6; x <= 6; ++x) {
      vec2 d = vec2(x, y) * spacing;
      vec3 v = IMG_PIXEL(inputImage, gl_FragCoord.xy + d).rgb;
      vec3 e = (v - c.rgb) / range;
      float w = exp(-0.5 * dot(d, d) / max(s * s, 0.01) - 0.5 * dot(e, e));
      sum += w * v;
      weights += w;
    }
  gl_FragColor = vec4(sum / weights, c.a);
}
