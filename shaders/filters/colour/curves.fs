/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Tone curves through points of your own: of all channels, then of red, green and blue",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "INPUTS": [
      {"NAME": "tone", "TYPE": "curve", "LABEL": "All", "DEFAULT": [[0, 0], [0.25, 0.2], [0.5, 0.5], [0.75, 0.8], [1, 1]]},
      {"NAME": "red", "TYPE": "curve", "LABEL": "Red"},
      {"NAME": "green", "TYPE": "curve", "LABEL": "Green"},
      {"NAME": "blue", "TYPE": "curve", "LABEL": "Blue"}
    ],
    "TOOLTIP": {"tone": "From a code, 0 to 1, to another: a gentle S, until it is drawn otherwise", "red": "After the first", "green": "After the first", "blue": "After the first"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(red(tone(c.r)), green(tone(c.g)), blue(tone(c.b)), c.a);
}
