/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Lines for composing: thirds, the golden section, centre, safe areas",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "show", "TYPE": "long", "LABEL": "Show", "VALUES": [0, 1, 2, 3], "LABELS": ["thirds", "golden section", "centre", "safe areas"], "DEFAULT": 0},
    {"NAME": "width", "TYPE": "float", "LABEL": "Width", "DEFAULT": 1.5, "MIN": 0.5, "MAX": 10},
    {"NAME": "color", "TYPE": "color", "LABEL": "Color", "DEFAULT": [1, 1, 1, 0.6]}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"width": "px of 1920"}
  }
}*/
float lineAt(float p, float at, float size) { return step(abs(p - at) * size, 0.5 * max(1.0, width * RENDERSIZE.x / 1920.0)); }
float frame(vec2 p, float part) {
  vec2 d = abs(p - 0.5) * 2.0 / part;
  vec2 edge = abs(abs(p - 0.5) * 2.0 - part) * 0.5 * RENDERSIZE;
  float w = 0.5 * max(1.0, width * RENDERSIZE.x / 1920.0);
  return max(step(edge.x, w) * step(d.y, 1.0), step(edge.y, w) * step(d.x, 1.0));
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 p = isf_FragNormCoord;
  float on = 0.0;
  if (show == 0 || show == 1) {
    float a = show == 0 ? 1.0 / 3.0 : 0.381966;
    on = max(max(lineAt(p.x, a, RENDERSIZE.x), lineAt(p.x, 1.0 - a, RENDERSIZE.x)),
             max(lineAt(p.y, a, RENDERSIZE.y), lineAt(p.y, 1.0 - a, RENDERSIZE.y)));
  }
  if (show == 2) on = max(lineAt(p.x, 0.5, RENDERSIZE.x), lineAt(p.y, 0.5, RENDERSIZE.y));
  if (show == 3) on = max(frame(p, 0.93), frame(p, 0.90));  // EBU R 95: action and graphics
  gl_FragColor = vec4(mix(c.rgb, color.rgb, on * color.a), c.a);
}
