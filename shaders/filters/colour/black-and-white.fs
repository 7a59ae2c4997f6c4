/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Panchromatic film behind a coloured filter",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "glass", "TYPE": "long", "LABEL": "Glass", "VALUES": [0, 1, 2, 3, 4, 5], "LABELS": ["none", "yellow", "orange", "red", "green", "blue"], "DEFAULT": 0},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 0.3, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"glass": "The filter before the lens: red darkens skies"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 weights = vec3(0.299, 0.587, 0.114);
  if (glass == 1) weights = vec3(0.45, 0.50, 0.05);
  if (glass == 2) weights = vec3(0.62, 0.36, 0.02);
  if (glass == 3) weights = vec3(0.90, 0.10, 0.00);
  if (glass == 4) weights = vec3(0.20, 0.72, 0.08);
  if (glass == 5) weights = vec3(0.08, 0.27, 0.65);
  float v = dot(c.rgb, weights);
  v = clamp(v, 0.0, 1.0);
  float curved = v * v * (3.0 - 2.0 * v);
  gl_FragColor = vec4(vec3(mix(v, curved, contrast)), c.a);
}
