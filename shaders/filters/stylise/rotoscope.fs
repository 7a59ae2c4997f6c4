/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Traced by hand: few flat colours with thick outlines, held for some frames",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "levels", "TYPE": "float", "LABEL": "Levels", "DEFAULT": 4, "MIN": 2, "MAX": 10},
    {"NAME": "line", "TYPE": "float", "LABEL": "Line", "DEFAULT": 2, "MIN": 0.5, "MAX": 8},
    {"NAME": "hand", "TYPE": "float", "LABEL": "Hand", "DEFAULT": 3, "MIN": 0, "MAX": 12}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": "ceil(30 * $WIDTH / 1920) + 8",
    "SAMPLING": "nearest",
    "UNIT": {"levels": "tones", "line": "px of 1920", "hand": "px of 1920"},
    "TOOLTIP": {"hand": "How unsteady the hand is"}
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

vec3 traced(vec2 at) {
  vec3 sum = vec3(0.0);
  for (int y = -3; y <= 3; ++y)
    for (int x = -3; x <= 3; ++x) sum += IMG_PIXEL(inputImage, at + vec2(x, y) * max(floor(RENDERSIZE.x / 1920.0 + 0.5), 1.0)).rgb;
  vec3 c = sum / 49.0;
  float high = max(c.r, max(c.g, c.b));
  float tone = (floor(high * levels) + 0.5) / levels;
  return clamp(c / max(high, 0.02) * tone, 0.0, 1.0);
}
void main() {
  float scale = RENDERSIZE.x / 1920.0;
  int held = FRAMEINDEX / 3;  // drawn on every third frame
  vec2 p = gl_FragCoord.xy / (40.0 * scale);
  ivec2 i = ivec2(floor(p));
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  vec2 shake = vec2(0.0);
  for (int k = 0; k < 4; ++k) {
    ivec2 q = i + ivec2(k & 1, k >> 1);
    vec2 w = mix(1.0 - f, f, vec2(k & 1, k >> 1));
    int key = hash(q.x + hash(q.y + hash(held)));
    shake += w.x * w.y * (vec2(uniformOf(key), uniformOf(hash(key))) - 0.5);
  }
  vec2 at = gl_FragCoord.xy + floor(shake * 2.0 * hand * scale + 0.5);
  vec3 c = traced(at);
  float e = 0.0, r = max(line * scale, 1.0);
  for (int k = 0; k < 8; ++k) {
    float a = 0.78539816 * float(k);
    e = max(e, grey(abs(traced(at + floor(r * vec2(cos(a), sin(a)) + 0.5)) - c)));
  }
  gl_FragColor = vec4(c * (1.0 - smoothstep(0.04, 0.10, e)), IMG_THIS_PIXEL(inputImage).a);
}
