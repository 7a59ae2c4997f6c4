/*{
  "ISFVSN": "2",
  "DESCRIPTION": "A matte of what is bright, or dark",
  "CATEGORIES": ["Key"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "low", "TYPE": "float", "LABEL": "Low", "DEFAULT": 0.2, "MIN": 0, "MAX": 1},
    {"NAME": "high", "TYPE": "float", "LABEL": "High", "DEFAULT": 0.3, "MIN": 0, "MAX": 1},
    {"NAME": "invert", "TYPE": "bool", "LABEL": "Invert", "DEFAULT": false},
    {"NAME": "show", "TYPE": "long", "LABEL": "Show", "VALUES": [0, 1], "LABELS": ["the picture with alpha", "the matte"], "DEFAULT": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"invert": "Keeps the dark"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float y = dot(c.rgb, vec3(0.299, 0.587, 0.114));
  float matte = smoothstep(low, max(high, low + 0.001), y);
  if (invert) matte = 1.0 - matte;
  gl_FragColor = show == 1 ? vec4(vec3(matte), 1.0) : vec4(c.rgb, c.a * matte);
}
