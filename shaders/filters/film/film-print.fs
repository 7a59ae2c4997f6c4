/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The curve and colour of a cinema print: soft toe and shoulder, warm highlights, cool shadows",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 0.4, "MIN": 0, "MAX": 1},
    {"NAME": "warmth", "TYPE": "float", "LABEL": "Warmth", "DEFAULT": 0.5, "MIN": -1, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
// A logistic curve a layer, in the code's own near-logarithmic scale; the layers part a little at the ends.
vec3 print(vec3 v, vec3 middle, vec3 gamma) { return 1.0 / (1.0 + exp(-gamma * (v - middle))); }
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 gamma = vec3(4.0 + 3.0 * contrast) * vec3(1.03, 1.0, 0.95);
  vec3 middle = vec3(0.46, 0.47, 0.48) - 0.02 * warmth * vec3(1.0, 0.0, -1.0);
  vec3 dark = print(vec3(0.0), middle, gamma), white = print(vec3(1.0), middle, gamma);
  vec3 v = (print(c.rgb, middle, gamma) - dark) / (white - dark);
  v = v * (vec3(0.985, 0.975, 0.955) - 0.02) + vec3(0.020, 0.024, 0.028);  // print white and print black
  gl_FragColor = vec4(mix(c.rgb, v, amount), c.a);
}
