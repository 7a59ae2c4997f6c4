/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Darker towards the corners, by the cosine to the fourth power of a lens",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "focal", "TYPE": "float", "LABEL": "Focal", "DEFAULT": 24, "MIN": 8, "MAX": 200}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"focal": "mm"},
    "TOOLTIP": {"amount": "1 is what the lens does, uncorrected", "focal": "Shorter is darker in the corners"}
  }
}*/
// cos^4 of the angle under which a lens of this focal length sees the place (36 mm wide frame).
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 p = (gl_FragCoord.xy - 0.5 * RENDERSIZE) / RENDERSIZE.x * 36.0 / focal;
  float cosine2 = 1.0 / (1.0 + dot(p, p));
  gl_FragColor = vec4(c.rgb * mix(1.0, cosine2 * cosine2, amount), c.a);
}
