/*{
  "ISFVSN": "2",
  "DESCRIPTION": "A colour for the shadows, another one for the highlights",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "shadows", "TYPE": "color", "LABEL": "Shadows", "DEFAULT": [0.25, 0.45, 0.6, 1]},
    {"NAME": "highlights", "TYPE": "color", "LABEL": "Highlights", "DEFAULT": [0.65, 0.5, 0.3, 1]},
    {"NAME": "balance", "TYPE": "float", "LABEL": "Balance", "DEFAULT": 0, "MIN": -4, "MAX": 4},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.5, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"balance": "stops"},
    "TOOLTIP": {"balance": "Where one becomes the other, over middle grey"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float light = max(luma(c.rgb), 0.0);
  float high = light / (light + 0.18 * exp2(balance));  // 0 in the shadows, 1 in the highlights, at any brightness
  vec3 shade = shadows.rgb / max(luma(shadows.rgb), 0.001), glow = highlights.rgb / max(luma(highlights.rgb), 0.001);
  gl_FragColor = vec4(c.rgb * mix(vec3(1.0), mix(shade, glow, high), amount), c.a);
}
