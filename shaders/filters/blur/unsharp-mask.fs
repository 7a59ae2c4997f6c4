/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Sharper, by the difference from a blurred copy",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.8, "MIN": 0, "MAX": 4},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 2, "MIN": 0.3, "MAX": 20}
  ],
  "PASSES": [
    {"TARGET": "across", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(3 * $radius * $WIDTH / 1920) + 3",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"radius": "Standard deviation"}
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
  float s = max(radius * RENDERSIZE.x / 1920.0, 0.3);
  vec4 soft = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s, gl_FragCoord.xy);
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = PASSINDEX == 0 ? soft : vec4(c.rgb + amount * (c.rgb - soft.rgb), c.a);
}
