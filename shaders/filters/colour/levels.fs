/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Black point, white point and gamma",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "black", "TYPE": "float", "LABEL": "Black", "DEFAULT": 0.05, "MIN": 0, "MAX": 0.9},
    {"NAME": "white", "TYPE": "float", "LABEL": "White", "DEFAULT": 0.95, "MIN": 0.1, "MAX": 1},
    {"NAME": "gamma", "TYPE": "float", "LABEL": "Gamma", "DEFAULT": 1, "MIN": 0.2, "MAX": 5}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 v = clamp((c.rgb - black) / max(white - black, 0.001), 0.0, 1.0);
  gl_FragColor = vec4(pow(v, vec3(1.0 / gamma)), c.a);
}
