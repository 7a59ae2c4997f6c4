/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Edges of one size: a narrow blur less a wide one",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 2, "MIN": 0.5, "MAX": 6},
    {"NAME": "gain", "TYPE": "float", "LABEL": "Gain", "DEFAULT": 4, "MIN": 0, "MAX": 20}
  ],
  "PASSES": [
    {"TARGET": "across", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": "ceil(5 * $sigma * $WIDTH / 1920) + 4",
    "SAMPLING": "nearest",
    "UNIT": {"sigma": "px of 1920"},
    "TOOLTIP": {"sigma": "Of the narrow one; the wide one is 1.6 times as wide"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
// Both Gaussians at once: the narrow one in red, the wide one in green.
vec2 row(vec2 direction, float narrow, float wide) {
  vec2 sum = vec2(0.0), weights = vec2(0.0);
  int reach = int(clamp(ceil(3.0 * wide), 1.0, 128.0));
  for (int i = -reach; i <= reach; ++i) {
    float x = float(i);
    vec2 w = exp(-0.5 * x * x / vec2(narrow * narrow, wide * wide));
    vec2 p = gl_FragCoord.xy + direction * x;
    sum += w * (PASSINDEX == 0 ? vec2(grey(IMG_PIXEL(inputImage, p).rgb)) : IMG_PIXEL(across, p).rg);
    weights += w;
  }
  return sum / weights;
}

void main() {
  float s = max(sigma * RENDERSIZE.x / 1920.0, 0.4);
  vec2 g = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s, 1.6 * s);
  gl_FragColor = PASSINDEX == 0 ? vec4(g, 0.0, 1.0) : vec4(vec3(0.5 + gain * (g.r - g.g)), IMG_THIS_PIXEL(inputImage).a);
}
