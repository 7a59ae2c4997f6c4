/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Paint: flat strokes with sharp edges",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 8, "MIN": 2, "MAX": 24},
    {"NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DEFAULT": 8, "MIN": 1, "MAX": 18}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 17,
    "SAMPLING": "nearest",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"radius": "Length of a stroke", "sharpness": "q of the paper"}
  }
}*/
// The generalized Kuwahara filter (Papari et al. 2007): of eight sectors around a place, those that vary least.
void main() {
  float reach = clamp(radius * RENDERSIZE.x / 1920.0, 2.0, 16.0);
  int n = int(ceil(reach));
  vec4 sums[8];  // of colours and weights
  vec3 squares[8];
  for (int k = 0; k < 8; ++k) {
    sums[k] = vec4(0.0);
    squares[k] = vec3(0.0);
  }
  for (int y = -n; y <= n; ++y)
    for (int x = -n; x <= n; ++x) {
      vec2 d = vec2(x, y);
      float r2 = dot(d, d) / (reach * reach);
      if (r2 > 1.0) continue;
      vec3 c = IMG_PIXEL(inputImage, gl_FragCoord.xy + d).rgb;
      float fall = exp(-3.0 * r2);
      float angle = atan(d.y, d.x) / 0.78539816;  // in sectors
      for (int k = 0; k < 8; ++k) {
        float off = abs(mod(angle - float(k) + 4.0, 8.0) - 4.0);
        float w = r2 == 0.0 ? 0.125 : fall * max(1.0 - off, 0.0);
        sums[k] += w * vec4(c, 1.0);
        squares[k] += w * c * c;
      }
    }
  vec4 result = vec4(0.0);
  for (int k = 0; k < 8; ++k) {
    vec3 mean = sums[k].rgb / sums[k].a, variance = abs(squares[k] / sums[k].a - mean * mean);
    float w = 1.0 / (1.0 + pow(255.0 * 255.0 * (variance.r + variance.g + variance.b), 0.5 * sharpness));
    result += w * vec4(mean, 1.0);
  }
  gl_FragColor = vec4(result.rgb / result.a, IMG_THIS_PIXEL(inputImage).a);
}
