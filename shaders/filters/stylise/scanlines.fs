/*{
  "ISFVSN": "2",
  "DESCRIPTION": "An old tube screen: dark lines, a rolling bar, a curved glass",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "lines", "TYPE": "float", "LABEL": "Lines", "DEFAULT": 270, "MIN": 60, "MAX": 1080},
    {"NAME": "depth", "TYPE": "float", "LABEL": "Depth", "DEFAULT": 0.45, "MIN": 0, "MAX": 1},
    {"NAME": "roll", "TYPE": "float", "LABEL": "Roll", "DEFAULT": 0.6, "MIN": 0, "MAX": 1},
    {"NAME": "noise", "TYPE": "float", "LABEL": "Noise", "DEFAULT": 0.2, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"lines": "lines"},
    "TOOLTIP": {"lines": "From top to bottom", "roll": "A bright bar that moves"}
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

void main() {
  vec2 p = isf_FragNormCoord;
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float row = p.y * lines;
  float dark = 0.5 + 0.5 * cos(6.2831853 * row);
  float bar = exp(-40.0 * pow(fract(p.y + TIME * 0.15) - 0.5, 2.0));
  float n = normalOf(hash(int(floor(gl_FragCoord.x)) + hash(int(floor(row)) + hash(FRAMEINDEX))));
  vec3 v = c.rgb * (1.0 - depth * dark) + 0.06 * roll * bar + noise * 0.1 * n;
  v /= 1.0 - 0.5 * depth;  // as bright as before, on average
  gl_FragColor = vec4(v, c.a);
}
