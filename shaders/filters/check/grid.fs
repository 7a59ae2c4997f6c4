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
// In whole pixels: where a line's middle lies between two of them, no card's rounding is to choose.
float thickness() { return max(1.0, floor(width * RENDERSIZE.x / 1920.0 + 0.5)); }
float firstPixel(float middle) { return floor(middle - 0.5 * thickness() + 0.51); }
float line(float pixel, float first) { return step(first, pixel) * step(pixel, first + thickness() - 1.0); }
float lineAt(float pixel, float at, float size) { return line(pixel, firstPixel(at * size)); }
float linesAt(vec2 pixel, float at) {
  vec2 mirrored = RENDERSIZE - 1.0 - pixel;
  return max(max(lineAt(pixel.x, at, RENDERSIZE.x), lineAt(mirrored.x, at, RENDERSIZE.x)),
             max(lineAt(pixel.y, at, RENDERSIZE.y), lineAt(mirrored.y, at, RENDERSIZE.y)));
}
float frame(vec2 pixel, float part) {
  vec2 inward = min(pixel, RENDERSIZE - 1.0 - pixel);
  vec2 edge = 0.5 * (1.0 - part) * RENDERSIZE;
  vec2 first = vec2(firstPixel(edge.x), firstPixel(edge.y));
  vec2 inside = step(first, inward);
  return inside.x * inside.y * max(line(inward.x, first.x), line(inward.y, first.y));
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 pixel = floor(gl_FragCoord.xy);
  float on = 0.0;
  if (show == 0) on = linesAt(pixel, 1.0 / 3.0);
  if (show == 1) on = linesAt(pixel, 0.381966);
  if (show == 2) on = max(lineAt(pixel.x, 0.5, RENDERSIZE.x), lineAt(pixel.y, 0.5, RENDERSIZE.y));
  if (show == 3) on = max(frame(pixel, 0.93), frame(pixel, 0.90));  // EBU R 95: action and graphics
  gl_FragColor = vec4(mix(c.rgb, color.rgb, on * color.a), c.a);
}
