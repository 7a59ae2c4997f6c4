/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Light through a crack of the camera",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.8, "MIN": 0, "MAX": 8},
    {"NAME": "color", "TYPE": "color", "LABEL": "Color", "DEFAULT": [1, 0.35, 0.08, 1]},
    {"NAME": "width", "TYPE": "float", "LABEL": "Width", "DEFAULT": 0.18, "MIN": 0.02, "MAX": 1},
    {"NAME": "side", "TYPE": "long", "LABEL": "Side", "VALUES": [0, 1, 2, 3], "LABELS": ["left", "right", "bottom", "top"], "DEFAULT": 0},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"width": "of the width"},
    "TOOLTIP": {"amount": "1 is as bright as white"}
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
  vec4 c = IMG_THIS_PIXEL(inputImage);
  int key = hash(int(seed) + hash(FRAMEINDEX / 12));
  vec2 p = isf_FragNormCoord;
  float x = side == 0 ? p.x : side == 1 ? 1.0 - p.x : side == 2 ? p.y : 1.0 - p.y;
  float along = side < 2 ? p.y : p.x;
  float bend = 0.15 * sin(along * 3.0 + 6.28 * uniformOf(key)) + 0.08 * sin(along * 7.0 + 6.28 * uniformOf(hash(key)));
  float leak = exp(-max(x + bend, 0.0) / max(width, 0.01));
  gl_FragColor = vec4(c.rgb + color.rgb * amount * leak * leak, c.a);  // light is added
}
