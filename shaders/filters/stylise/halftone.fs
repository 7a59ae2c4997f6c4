/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Printed dots: their size is the darkness",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "steps", "TYPE": "float", "LABEL": "Steps", "DEFAULT": 128, "MIN": 16, "MAX": 512},
    {"NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DEFAULT": 45, "MIN": -90, "MAX": 90},
    {"NAME": "inks", "TYPE": "long", "LABEL": "Inks", "VALUES": [0, 1], "LABELS": ["black", "four colours"], "DEFAULT": 0}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"steps": "cells", "angle": "degrees"},
    "TOOLTIP": {"steps": "Across the picture"}
  }
}*/
// Square cells across the picture, turned; a dot covers as much of its cell as the place is dark.
float cover(vec3 c) { return 1.0 - dot(c, vec3(0.299, 0.587, 0.114)); }
float dots(float angle, float dark, vec2 p, float cell) {
  mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
  vec2 d = fract(turn * p / cell) - 0.5;
  dark = clamp(dark, 0.0, 1.0);
  float radius = mix(sqrt(dark / 3.14159265), 0.72, smoothstep(0.7, 1.0, dark));  // the last corners close
  return smoothstep(-0.7 / cell, 0.7 / cell, radius - length(d));
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float cell = RENDERSIZE.x / steps, a = radians(angle);
  vec3 paper = vec3(1.0);
  if (inks == 0) paper *= 1.0 - dots(a, cover(c.rgb), gl_FragCoord.xy, cell);
  if (inks == 1) {  // cyan, magenta, yellow and black plates at their usual angles
    float k = 1.0 - max(c.r, max(c.g, c.b));
    vec3 cmy = (1.0 - c.rgb - k) / max(1.0 - k, 0.001);
    paper.r *= 1.0 - dots(a + radians(15.0), cmy.r, gl_FragCoord.xy, cell);
    paper.g *= 1.0 - dots(a + radians(75.0), cmy.g, gl_FragCoord.xy, cell);
    paper.b *= 1.0 - dots(a, cmy.b, gl_FragCoord.xy, cell);
    paper *= 1.0 - dots(a + radians(45.0), k, gl_FragCoord.xy, cell);
  }
  gl_FragColor = vec4(paper, c.a);
}
