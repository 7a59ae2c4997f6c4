/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Scratches, dust and a worn print",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "damage", "TYPE": "float", "LABEL": "Damage", "DEFAULT": 0.5, "MIN": 0, "MAX": 1},
    {"NAME": "fade", "TYPE": "float", "LABEL": "Fade", "DEFAULT": 0.7, "MIN": 0, "MAX": 1},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"damage": "How many scratches and specks", "fade": "How much colour is gone"}
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
  vec2 p = isf_FragNormCoord;
  vec3 v = mix(c.rgb, grey(c.rgb) * vec3(1.06, 0.98, 0.82), fade);
  float wide = 1.0 / 1920.0;
  for (int i = 0; i < 6; ++i) {  // scratches stay for some frames
    int key = hash(i + hash(FRAMEINDEX / 8 + hash(int(seed))));
    float x = uniformOf(key) + 0.002 * sin(p.y * 9.0 + float(FRAMEINDEX));
    float there = step(uniformOf(hash(key + 1)), damage);
    v += there * 0.35 * smoothstep(wide, 0.0, abs(p.x - x)) * (uniformOf(hash(key + 2)) > 0.4 ? 1.0 : -1.0);
  }
  for (int i = 0; i < 12; ++i) {  // dust is of one frame
    int key = hash(i + 100 + hash(FRAMEINDEX + hash(int(seed))));
    vec2 at = vec2(uniformOf(key), uniformOf(hash(key + 1)));
    float radius = (1.0 + 5.0 * uniformOf(hash(key + 2))) / 1920.0;
    vec2 d = (p - at) * vec2(1.0, RENDERSIZE.y / RENDERSIZE.x);
    float there = step(uniformOf(hash(key + 3)), damage);
    v -= there * 0.6 * smoothstep(radius, radius * 0.5, length(d));
  }
  gl_FragColor = vec4(v, c.a);
}
