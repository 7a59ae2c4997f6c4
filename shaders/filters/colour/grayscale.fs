/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Black and white by weights of the channels",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "red", "TYPE": "float", "LABEL": "Red", "DEFAULT": 0.3, "MIN": -1, "MAX": 2},
    {"NAME": "green", "TYPE": "float", "LABEL": "Green", "DEFAULT": 0.59, "MIN": -1, "MAX": 2},
    {"NAME": "blue", "TYPE": "float", "LABEL": "Blue", "DEFAULT": 0.11, "MIN": -1, "MAX": 2}
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
  gl_FragColor = vec4(vec3(dot(c.rgb, vec3(red, green, blue))), c.a);
}
