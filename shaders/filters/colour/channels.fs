/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Shows one part of the colour as a grey picture",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "show", "TYPE": "long", "LABEL": "Show", "VALUES": [0, 1, 2, 3, 4, 5, 6, 7, 8], "LABELS": ["red", "green", "blue", "hue", "saturation", "value", "luma Y", "Cb", "Cr"], "DEFAULT": 6}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float high = max(c.r, max(c.g, c.b)), low = min(c.r, min(c.g, c.b)), range = high - low;
  float hue = range <= 0.0 ? 0.0 : high == c.r ? (c.g - c.b) / range : high == c.g ? 2.0 + (c.b - c.r) / range
                                                                                  : 4.0 + (c.r - c.g) / range;
  float y = dot(c.rgb, vec3(0.299, 0.587, 0.114));
  float v = show == 0 ? c.r : show == 1 ? c.g : show == 2 ? c.b : show == 3 ? fract(hue / 6.0 + 1.0)
            : show == 4 ? (high > 0.0 ? range / high : 0.0) : show == 5 ? high : show == 6 ? y
            : show == 7 ? (c.b - y) / 1.772 + 0.5 : (c.r - y) / 1.402 + 0.5;
  gl_FragColor = vec4(vec3(v), c.a);
}
