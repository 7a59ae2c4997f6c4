/*{
  "ISFVSN": "2",
  "DESCRIPTION": "White where it is bright, black elsewhere",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "level", "TYPE": "float", "LABEL": "Level", "DEFAULT": 0.5, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(vec3(step(level, grey(c.rgb))), c.a);
}
