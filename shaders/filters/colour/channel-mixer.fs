/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes each channel out of red, green and blue",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "INPUTS": [
      {"NAME": "matrix", "TYPE": "matrix", "LABEL": "Matrix", "DEFAULT": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "MIN": -4, "MAX": 4}
    ],
    "TOOLTIP": {"matrix": "A row a channel: how much of red, green and blue it is made of"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(matrix * c.rgb, c.a);
}
