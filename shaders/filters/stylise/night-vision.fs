/*{
  "ISFVSN": "2",
  "DESCRIPTION": "An image intensifier: green, grainy, round",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "gain", "TYPE": "float", "LABEL": "Gain", "DEFAULT": 2, "MIN": 1, "MAX": 6},
    {"NAME": "noise", "TYPE": "float", "LABEL": "Noise", "DEFAULT": 0.12, "MIN": 0, "MAX": 1},
    {"NAME": "tunnel", "TYPE": "float", "LABEL": "Tunnel", "DEFAULT": 0.8, "MIN": 0, "MAX": 1},
    {"NAME": "tint", "TYPE": "color", "LABEL": "Tint", "DEFAULT": [0.15, 0.95, 0.25, 1]},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"gain": "How much the dark is lifted", "tunnel": "How much of the corners the tube hides"}
  }
}*/
// PCG (O'Neill 2014) in whole numbers, so that every graphics card draws the same.
int shifted(int v, int n) { return (v >> n) & ((1 << (32 - n)) - 1); }
int hash(int v) {
  v = v * 747796405 - 1403630843;
  int w = (shifted(v, shifted(v, 28) + 4) ^ v) * 277803737;
  return shifted(w, 22) ^ w;
}
float uniformOf(int h) { return float(shifted(h, 8)) / 16777216.0; }
// Four sums of bytes: nearly a normal distribution, mean 0, standard deviation 1.
float normalOf(int h) {
  float sum = float(h & 255) + float(shifted(h, 8) & 255) + float(shifted(h, 16) & 255) + float(shifted(h, 24));
  return (sum / 255.0 - 2.0) * 1.7320508;
}
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 p = (gl_FragCoord.xy - 0.5 * RENDERSIZE) / RENDERSIZE.y;
  vec2 lattice = floor(gl_FragCoord.xy * 1920.0 / (RENDERSIZE.x * 2.0));
  float n = normalOf(hash(int(lattice.x) + hash(int(lattice.y) + hash(FRAMEINDEX + hash(int(seed))))));
  float light = pow(grey(c.rgb), 1.0 / gain);
  float v = clamp(light + noise * n * (1.1 - light), 0.0, 1.0);
  float tube = smoothstep(0.62, 0.45, length(p) * mix(0.6, 1.0, tunnel));
  vec3 green = tint.rgb * v + 0.35 * v * v * v;
  gl_FragColor = vec4(green * tube, c.a);
}
