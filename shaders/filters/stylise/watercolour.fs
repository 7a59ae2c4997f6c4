/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Watercolour on paper: washes, darker rims, the paper shows",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 6, "MIN": 1, "MAX": 16},
    {"NAME": "bleed", "TYPE": "float", "LABEL": "Bleed", "DEFAULT": 1, "MIN": 0, "MAX": 4},
    {"NAME": "rim", "TYPE": "float", "LABEL": "Rim", "DEFAULT": 1, "MIN": 0, "MAX": 3},
    {"NAME": "grain", "TYPE": "float", "LABEL": "Grain", "DEFAULT": 0.8, "MIN": 0, "MAX": 2}
  ],
  "PASSES": [
    {"TARGET": "washed", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "7 + ceil(16 * $WIDTH / 1920) + 6",
    "SAMPLING": "nearest",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"bleed": "How far the paint runs", "grain": "How much of the paper shows"}
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

float paper(vec2 p) {  // fractal noise
  float sum = 0.0, scale = 1.0;
  for (int o = 0; o < 4; ++o) {
    vec2 q = p / (24.0 * scale);
    ivec2 i = ivec2(floor(q));
    vec2 f = fract(q);
    f = f * f * (3.0 - 2.0 * f);
    float a = uniformOf(hash(i.x + hash(i.y + 57 * o))), b = uniformOf(hash(i.x + 1 + hash(i.y + 57 * o)));
    float c = uniformOf(hash(i.x + hash(i.y + 1 + 57 * o))), d = uniformOf(hash(i.x + 1 + hash(i.y + 1 + 57 * o)));
    sum += scale * mix(mix(a, b, f.x), mix(c, d, f.x), f.y);
    scale *= 0.5;
  }
  return sum / 1.875;
}
vec3 wash(vec2 at) {  // four quadrants, the smoothest one (Kuwahara 1976)
  int n = int(clamp(radius * RENDERSIZE.x / 1920.0, 1.0, 6.0));
  vec3 best = vec3(0.0);
  float least = 1e9;
  for (int q = 0; q < 4; ++q) {
    vec2 s = vec2(q % 2 == 0 ? -1.0 : 1.0, q / 2 == 0 ? -1.0 : 1.0);
    vec3 mean = vec3(0.0);
    float square = 0.0;
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) {
        vec3 c = IMG_PIXEL(inputImage, at + s * vec2(x, y)).rgb;
        mean += c;
        square += dot(c, c);
      }
    float count = float((n + 1) * (n + 1));
    mean /= count;
    float variance = square / count - dot(mean, mean);
    if (variance < least) {
      least = variance;
      best = mean;
    }
  }
  return best;
}
void main() {
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(wash(gl_FragCoord.xy), 1.0);
    return;
  }
  vec2 p = gl_FragCoord.xy * 1920.0 / RENDERSIZE.x;
  vec2 wobble = bleed * RENDERSIZE.x / 1920.0 * (vec2(paper(p), paper(p + 500.0)) - 0.5) * 6.0;
  vec2 at = gl_FragCoord.xy + floor(wobble + 0.5);
  vec3 c = IMG_PIXEL(washed, at).rgb, around = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    float a = 0.78539816 * float(i);
    around += IMG_PIXEL(washed, at + floor(4.0 * RENDERSIZE.x / 1920.0 * vec2(cos(a), sin(a)) + 0.5)).rgb / 8.0;
  }
  // Pigment gathers at the rims; density is a multiplication (Bousseau et al. 2006): c - (c - c^2)(d - 1).
  float density = 1.0 + 1.6 * rim * grey(abs(c - around)) * 4.0 + grain * (paper(p) - 0.5);
  c = c - (c - c * c) * (density - 1.0);
  c = mix(vec3(0.98, 0.97, 0.94), c, 0.9);
  gl_FragColor = vec4(c, IMG_THIS_PIXEL(inputImage).a);
}
