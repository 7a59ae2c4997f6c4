/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The frame wanders a little in the gate",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1.5, "MIN": 0, "MAX": 10},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "HALO": "ceil(2 * $amount * $WIDTH / 1920) + 1",
    "UNIT": {"amount": "px of 1920"}
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
  // Slow and fast wandering; whole pixels would jump, so the picture is interpolated.
  float t = float(FRAMEINDEX);
  int key = hash(int(seed));
  vec2 slow = vec2(sin(t * 0.31 + uniformOf(key) * 6.28), cos(t * 0.23 + uniformOf(hash(key)) * 6.28));
  vec2 fast = vec2(normalOf(hash(FRAMEINDEX + key)), normalOf(hash(FRAMEINDEX + hash(key))));
  vec2 offset = (0.7 * slow + 0.3 * fast) * amount * RENDERSIZE.x / 1920.0;
  gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy + offset);
}
