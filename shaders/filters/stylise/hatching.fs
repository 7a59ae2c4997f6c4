/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Pen strokes, crossed where it is dark",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "spacing", "TYPE": "float", "LABEL": "Spacing", "DEFAULT": 9, "MIN": 3, "MAX": 40},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 1.2, "MIN": 0.3, "MAX": 4},
    {"NAME": "inkColor", "TYPE": "color", "LABEL": "Ink color", "DEFAULT": [0.08, 0.07, 0.12, 1]},
    {"NAME": "paperColor", "TYPE": "color", "LABEL": "Paper color", "DEFAULT": [0.98, 0.96, 0.9, 1]}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"spacing": "px of 1920"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

float strokes(float angle, float spacing, float dark) {
  float a = radians(angle);
  vec2 p = gl_FragCoord.xy;
  float across = dot(p, vec2(-sin(a), cos(a))), along = dot(p, vec2(cos(a), sin(a)));
  float wobble = 0.12 * spacing * sin(along / (spacing * 7.0) + floor(across / spacing) * 2.4);
  float d = abs(fract((across + wobble) / spacing) - 0.5) * spacing;
  float reach = 0.5 * spacing * clamp(dark, 0.0, 0.95);
  return 1.0 - smoothstep(reach - 0.6, reach + 0.6, d);
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float dark = pow(1.0 - grey(c.rgb), contrast), s = spacing * RENDERSIZE.x / 1920.0;
  float ink = dark > 0.12 ? strokes(45.0, s, (dark - 0.12) * 0.9) : 0.0;
  if (dark > 0.4) ink = max(ink, strokes(-45.0, s, (dark - 0.4) * 0.9));
  if (dark > 0.65) ink = max(ink, strokes(0.0, s, (dark - 0.65) * 1.2));
  if (dark > 0.82) ink = max(ink, strokes(90.0, s, (dark - 0.82) * 2.0));
  gl_FragColor = vec4(mix(paperColor.rgb, inkColor.rgb, ink), c.a);
}
