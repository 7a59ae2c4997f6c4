/*{
  "ISFVSN": "2",
  "DESCRIPTION": "More or less colour at the same luminance",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 1.3, "MIN": 0, "MAX": 3}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"saturation": "0 is black and white, 1 changes nothing"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(mix(vec3(luma(c.rgb)), c.rgb, saturation), c.a);
}
