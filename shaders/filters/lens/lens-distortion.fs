/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Barrel and pincushion of a lens, or their correction",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "k1", "TYPE": "float", "LABEL": "K1", "DEFAULT": 0.12, "MIN": -0.5, "MAX": 0.5},
    {"NAME": "k2", "TYPE": "float", "LABEL": "K2", "DEFAULT": 0, "MIN": -0.5, "MAX": 0.5},
    {"NAME": "fill", "TYPE": "bool", "LABEL": "Fill", "DEFAULT": true}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil((abs($k1) + abs($k2)) * sqrt($WIDTH * $WIDTH + $HEIGHT * $HEIGHT) / 2) + 2",
    "TOOLTIP": {"k1": "Above 0: barrel", "fill": "Enlarged until nothing is black"}
  }
}*/
// Brown 1966: r' = r (1 + k1 r^2 + k2 r^4), r = 1 at the corner, scaled so that the corners stay.
void main() {
  vec2 p = (gl_FragCoord.xy - 0.5 * RENDERSIZE) / (0.5 * length(RENDERSIZE));
  float r2 = dot(p, p);
  float scale = (1.0 + k1 * r2 + k2 * r2 * r2) / (1.0 + (fill ? max(k1 + k2, 0.0) : 0.0));
  vec2 at = 0.5 * RENDERSIZE + p * scale * 0.5 * length(RENDERSIZE);
  vec4 c = IMG_PIXEL(inputImage, at);
  bool outside = any(lessThan(at, vec2(0.0))) || any(greaterThan(at, RENDERSIZE));
  gl_FragColor = outside ? vec4(0.0, 0.0, 0.0, 1.0) : c;
}
