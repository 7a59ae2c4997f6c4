/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Soft, evenly",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 6, "MIN": 0, "MAX": 60}
  ],
  "PASSES": [
    {"TARGET": "across", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(3 * $sigma * $WIDTH / 1920) + 2",
    "UNIT": {"sigma": "px of 1920"},
    "TOOLTIP": {"sigma": "Standard deviation"}
  }
}*/
// A Gaussian in two passes: across, then up, to three standard deviations.
vec4 row(vec2 direction, float sigma, vec2 p) {
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  int reach = int(clamp(ceil(2.0 * sigma), 1.0, 256.0));
  float spacing = 3.0 * sigma / float(reach);  // 1.5 pixels: interpolation sees all between
  for (int i = -reach; i <= reach; ++i) {
    float x = float(i) * spacing;
    float w = sigma > 0.01 ? exp(-0.5 * x * x / (sigma * sigma)) : (i == 0 ? 1.0 : 0.0);
    vec2 at = p + direction * x;
    sum += w * (PASSINDEX == 0 ? IMG_PIXEL(inputImage, at) : IMG_PIXEL(across, at));
    weights += w;
  }
  return sum / weights;
}

void main() {
  float s = sigma * RENDERSIZE.x / 1920.0;
  gl_FragColor = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s, gl_FragCoord.xy);
}
