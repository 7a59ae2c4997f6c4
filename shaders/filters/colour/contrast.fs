/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Contrast in stops about middle grey: highlights keep their colour",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 1.2, "MIN": 0.2, "MAX": 3},
    {"NAME": "pivot", "TYPE": "float", "LABEL": "Pivot", "DEFAULT": 0.18, "MIN": 0.01, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"contrast": "1 changes nothing", "pivot": "The light that stays: 0.18 is middle grey"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  // A power of light is a factor on stops. Negative light stays as it is.
  vec3 graded = pivot * pow(max(c.rgb, 0.0) / pivot, vec3(contrast));
  graded = min(graded, max(c.rgb, 65504.0));  // what files hold
  gl_FragColor = vec4(graded + min(c.rgb, 0.0), c.a);
}
