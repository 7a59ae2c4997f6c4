/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Ink drawing: the extended difference of Gaussians",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 2, "MIN": 0.5, "MAX": 6},
    {"NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DEFAULT": 20, "MIN": 0, "MAX": 100},
    {"NAME": "level", "TYPE": "float", "LABEL": "Level", "DEFAULT": 0.45, "MIN": 0, "MAX": 1},
    {"NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DEFAULT": 8, "MIN": 0.5, "MAX": 100},
    {"NAME": "ink", "TYPE": "color", "LABEL": "Ink", "DEFAULT": [0.05, 0.05, 0.08, 1]},
    {"NAME": "paper", "TYPE": "color", "LABEL": "Paper", "DEFAULT": [1, 0.99, 0.96, 1]}
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
    "TOOLTIP": {"sigma": "Width of a line", "sharpness": "p of the paper", "level": "Darker places become ink", "softness": "phi of the paper: higher is a harder edge"}
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

// Winnemoeller, Kyprianidis, Olsen 2012, equations 6 and 7: S = (1 + p) G(s) - p G(k s); white above eps, else a soft step.
void main() {
  float s = max(sigma * RENDERSIZE.x / 1920.0, 0.4);
  vec2 g = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s, 1.6 * s);
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(g, 0.0, 1.0);
    return;
  }
  float u = (1.0 + sharpness) * g.r - sharpness * g.g;
  float v = u >= level ? 1.0 : 1.0 + tanh(softness * (u - level));
  gl_FragColor = vec4(mix(ink.rgb, paper.rgb, v), IMG_THIS_PIXEL(inputImage).a);
}
