/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Stretches the frame from black to white by its own darkest and brightest places",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "perChannel", "TYPE": "bool", "LABEL": "Per channel", "DEFAULT": false}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "OVERVIEW": "overview",
    "TOOLTIP": {"perChannel": "Each channel for itself: takes colour casts out"}
  }
}*/
// The overview's extremes: averages over about a hundredth of the picture's width, so that a single pixel does not count.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 low = vec3(1.0), high = vec3(0.0);
  for (int y = 0; y < 24; ++y)
    for (int x = 0; x < 24; ++x) {
      vec3 v = IMG_NORM_PIXEL(overview, (vec2(x, y) + 0.5) / 24.0).rgb;
      low = min(low, v);
      high = max(high, v);
    }
  if (perChannel == false) {
    low = vec3(min(low.r, min(low.g, low.b)));
    high = vec3(max(high.r, max(high.g, high.b)));
  }
  vec3 stretched = clamp((c.rgb - low) / max(high - low, 0.02), 0.0, 1.0);
  gl_FragColor = vec4(mix(c.rgb, stretched, amount), c.a);
}
