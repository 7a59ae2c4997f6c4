/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Mixes another picture in",
  "CATEGORIES": ["Key"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "other", "TYPE": "image", "LABEL": "Other"},
    {"NAME": "mode", "TYPE": "long", "LABEL": "Mode", "VALUES": [0, 1, 2, 3, 4, 5, 6, 7], "LABELS": ["normal", "multiply", "screen", "overlay", "add", "difference", "darken", "lighten"], "DEFAULT": 0},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.5, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "TOOLTIP": {"other": "The other picture; it is stretched over the frame"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec4 o = IMG_NORM_PIXEL(other, isf_FragNormCoord);
  if (IMG_SIZE(other).x < 1.5) {
    gl_FragColor = c;
    return;
  }
  vec3 a = c.rgb, b = o.rgb;
  vec3 v = mode == 0   ? b
           : mode == 1 ? a * b
           : mode == 2 ? 1.0 - (1.0 - a) * (1.0 - b)
           : mode == 3 ? mix(2.0 * a * b, 1.0 - 2.0 * (1.0 - a) * (1.0 - b), step(0.5, a))
           : mode == 4 ? a + b
           : mode == 5 ? abs(a - b)
           : mode == 6 ? min(a, b)
                       : max(a, b);
  gl_FragColor = vec4(mix(a, v, amount * o.a), c.a);
}
