/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Oil paint: every place takes the commonest tone around it",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 6, "MIN": 1, "MAX": 16}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 9,
    "SAMPLING": "nearest",
    "UNIT": {"radius": "px of 1920"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
  int n = int(clamp(floor(radius * RENDERSIZE.x / 1920.0 + 0.5), 1.0, 8.0));
  vec4 bins[10];
  for (int k = 0; k < 10; ++k) bins[k] = vec4(0.0);
  for (int y = -n; y <= n; ++y)
    for (int x = -n; x <= n; ++x) {
      vec3 c = IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb;
      int k = int(clamp(grey(c) * 10.0, 0.0, 9.0));
      bins[k] += vec4(c, 1.0);
    }
  vec4 best = bins[0];
  for (int k = 1; k < 10; ++k)
    if (bins[k].a > best.a) best = bins[k];
  gl_FragColor = vec4(best.rgb / best.a, IMG_THIS_PIXEL(inputImage).a);
}
