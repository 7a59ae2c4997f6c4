/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Stripes over what is too bright or too dark",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "high", "TYPE": "float", "LABEL": "High", "DEFAULT": 0.95, "MIN": 0, "MAX": 1},
    {"NAME": "low", "TYPE": "float", "LABEL": "Low", "DEFAULT": 0.03, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"high": "Red stripes from here", "low": "Blue stripes below this"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float peak = max(c.r, max(c.g, c.b));
  float width = 8.0 * RENDERSIZE.x / 1920.0;
  float rising = step(0.5, fract((gl_FragCoord.x - gl_FragCoord.y) / (2.0 * width)));
  float falling = step(0.5, fract((gl_FragCoord.x + gl_FragCoord.y) / (2.0 * width)));
  vec3 v = c.rgb;
  if (peak >= high) v = mix(v, vec3(0.9, 0.1, 0.1), rising);
  if (peak < low) v = mix(v, vec3(0.15, 0.3, 0.95), falling);
  gl_FragColor = vec4(v, c.a);
}
