/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Marks light that a display or half float cannot hold, and negative light",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "white", "TYPE": "float", "LABEL": "White", "DEFAULT": 1, "MIN": 0.1, "MAX": 100}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"white": "Brighter is orange; negative is blue; beyond 65504 magenta"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float low = min(c.r, min(c.g, c.b)), high = max(c.r, max(c.g, c.b));
  vec3 base = vec3(0.15 * clamp(dot(c.rgb, vec3(0.2126, 0.7152, 0.0722)), 0.0, 1.0));
  vec3 v = high > 65504.0 ? vec3(1.0, 0.0, 1.0) : low < 0.0 ? vec3(0.1, 0.3, 1.0) : high > white ? vec3(1.0, 0.5, 0.0) : base;
  gl_FragColor = vec4(v, c.a);
}
