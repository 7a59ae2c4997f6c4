/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Black bars to another shape of frame",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "aspect", "TYPE": "float", "LABEL": "Aspect", "DEFAULT": 2.39, "MIN": 1, "MAX": 3},
    {"NAME": "opacity", "TYPE": "float", "LABEL": "Opacity", "DEFAULT": 1, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"aspect": "to 1"},
    "TOOLTIP": {"aspect": "2.39 is wide screen, 1.85 flat"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 d = abs(gl_FragCoord.xy - 0.5 * RENDERSIZE) * 2.0;
  bool outside = d.y > RENDERSIZE.x / aspect || d.x > RENDERSIZE.y * aspect;
  gl_FragColor = outside ? vec4(c.rgb * (1.0 - opacity), c.a) : c;
}
