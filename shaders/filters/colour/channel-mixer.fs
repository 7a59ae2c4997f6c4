/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Makes each channel out of red, green and blue",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "red", "TYPE": "color", "LABEL": "Red", "DEFAULT": [1, 0, 0, 1]},
    {"NAME": "green", "TYPE": "color", "LABEL": "Green", "DEFAULT": [0, 1, 0, 1]},
    {"NAME": "blue", "TYPE": "color", "LABEL": "Blue", "DEFAULT": [0, 0, 1, 1]}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"red": "How much of red, green and blue the red is made of", "green": "The same for green", "blue": "The same for blue"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(dot(c.rgb, red.rgb), dot(c.rgb, green.rgb), dot(c.rgb, blue.rgb), c.a);
}
