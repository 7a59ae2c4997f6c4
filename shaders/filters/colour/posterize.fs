/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Few levels a channel",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "levels", "TYPE": "float", "LABEL": "Levels", "DEFAULT": 4, "MIN": 2, "MAX": 32},
    {"NAME": "threshold", "TYPE": "float", "LABEL": "Threshold", "DEFAULT": 0.5, "MIN": 0.01, "MAX": 0.99}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"levels": "levels"},
    "TOOLTIP": {"levels": "2 is on or off", "threshold": "Where a value goes to the next level"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float last = max(float(levels) - 1.0, 1.0);
  gl_FragColor = vec4(floor(clamp(c.rgb, 0.0, 1.0) * last + 1.0 - threshold) / last, c.a);
}
