/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Brightens or darkens by stops, as a lens does",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "stops", "TYPE": "float", "LABEL": "Stops", "DEFAULT": 0, "MIN": -8, "MAX": 8}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"stops": "stops"},
    "TOOLTIP": {"stops": "+1 doubles the light"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(c.rgb * exp2(stops), c.a);
}
