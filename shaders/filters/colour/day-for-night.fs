/*{
  "ISFVSN": "2",
  "DESCRIPTION": "A day scene as night: darker, bluer, less colour, no bright sky",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "stops", "TYPE": "float", "LABEL": "Stops", "DEFAULT": -2, "MIN": -6, "MAX": 0},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 0.45, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"stops": "stops"},
    "TOOLTIP": {"stops": "How much darker than the day"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 light = max(c.rgb, 0.0) * exp2(stops);
  float y = luma(light);
  light = mix(vec3(y), light, saturation);
  light *= vec3(0.62, 0.85, 1.35) / 0.838;   // moonlight as films show it, at the same luminance
  float limit = 0.6;                          // bright places are compressed: there is no sun
  float peak = max(light.r, max(light.g, light.b));
  light *= peak > 0.0 ? limit * (1.0 - exp(-peak / limit)) / peak : 1.0;
  gl_FragColor = vec4(light + min(c.rgb, 0.0), c.a);
}
