/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Brightness that wavers from frame to frame, as an old projector",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.15, "MIN": 0, "MAX": 1},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"amount": "stops"},
    "TOOLTIP": {"amount": "Standard deviation"}
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
  float n = normalOf(hash(FRAMEINDEX + hash(int(seed))));
  gl_FragColor = vec4(c.rgb * exp2(amount * n), c.a);
}
