/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Grain of a film stock, by the frame number: the same on every computer",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.25, "MIN": 0, "MAX": 2},
    {"NAME": "size", "TYPE": "float", "LABEL": "Size", "DEFAULT": 1.6, "MIN": 0.5, "MAX": 8},
    {"NAME": "color", "TYPE": "float", "LABEL": "Color", "DEFAULT": 0.5, "MIN": 0, "MAX": 1},
    {"NAME": "seed", "TYPE": "float", "LABEL": "Seed", "DEFAULT": 1, "MIN": 0, "MAX": 1000}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"amount": "stops", "size": "px of 1920"},
    "TOOLTIP": {"amount": "Standard deviation in the shadows", "size": "Width of a grain", "color": "0: grey grain; 1: a grain a layer", "seed": "Another number, another grain"}
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
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// Noise on a lattice as wide as a grain, in stops: film's noise is in its density.
float lattice(vec2 p, int channel) {
  ivec2 i = ivec2(floor(p));
  vec2 f = fract(p);
  f = f * f * (3.0 - 2.0 * f);
  int key = hash(FRAMEINDEX + hash(int(seed) + 7919 * channel));
  float sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    ivec2 corner = ivec2(k & 1, k >> 1);
    vec2 w = mix(1.0 - f, f, vec2(corner));
    sum += w.x * w.y * normalOf(hash(i.x + corner.x + hash(i.y + corner.y + key)));
  }
  return sum;
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float grains = 1920.0 / (RENDERSIZE.x * size);  // across a pixel
  vec2 p = gl_FragCoord.xy * grains;
  float common1 = lattice(p, 0);
  vec3 noise = mix(vec3(common1), vec3(lattice(p, 1), lattice(p, 2), lattice(p, 3)), color);
  noise /= 0.743 * sqrt((1.0 - color) * (1.0 - color) + color * color);  // standard deviation 1 again
  // Most in the shadows and middle tones; highlights, where every crystal is developed, are smooth.
  float y = max(luma(c.rgb), 0.0);
  // A pixel that is wider than a grain sees the mean of several.
  float strength = amount * mix(1.0, 0.25, y / (y + 0.6)) / max(1.0, grains);
  vec3 stops = strength * noise;
  // The mean stays, as E exp2(s n) = exp2(s^2 ln 2 / 2).
  gl_FragColor = vec4(c.rgb * exp2(stops - 0.3466 * strength * strength), c.a);
}
