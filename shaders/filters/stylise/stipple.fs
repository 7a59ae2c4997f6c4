/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Dots of ink, closer where it is dark",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "spacing", "TYPE": "float", "LABEL": "Spacing", "DEFAULT": 6, "MIN": 3, "MAX": 40},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": "ceil(2 * $spacing * $WIDTH / 1920) + 2",
    "SAMPLING": "nearest",
    "UNIT": {"spacing": "px of 1920"}
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

// A jittered grid: each cell's dot is drawn where the place is darker than the cell's own number.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float cell = spacing * RENDERSIZE.x / 1920.0, ink = 0.0;
  vec2 here = floor(gl_FragCoord.xy / cell);
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x) {
      vec2 id = here + vec2(x, y);
      int key = hash(int(id.x) + hash(int(id.y) + hash(int(seed))));
      vec2 at = (id + 0.15 + 0.7 * vec2(uniformOf(key), uniformOf(hash(key + 1)))) * cell;
      float dark = 1.0 - grey(IMG_PIXEL(inputImage, clamp(at, vec2(0.5), RENDERSIZE - 0.5)).rgb);
      float radius = cell * 0.62 * sqrt(clamp(dark - 0.25 * uniformOf(hash(key + 2)), 0.0, 1.0));
      ink = max(ink, smoothstep(radius + 0.6, radius - 0.6, length(gl_FragCoord.xy - at)) * step(0.05, radius / cell));
    }
  gl_FragColor = vec4(mix(vec3(0.98, 0.97, 0.94), vec3(0.06, 0.06, 0.09), ink), c.a);
}
