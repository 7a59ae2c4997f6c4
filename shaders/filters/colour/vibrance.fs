/*{
  "ISFVSN": "2",
  "DESCRIPTION": "More colour where there is little, none more where there is much",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "vibrance", "TYPE": "float", "LABEL": "Vibrance", "DEFAULT": 0.5, "MIN": -1, "MAX": 2}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"vibrance": "0 changes nothing"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float high = max(c.r, max(c.g, c.b)), low = min(c.r, min(c.g, c.b));
  float saturation = high > 0.0 ? clamp((high - low) / high, 0.0, 1.0) : 1.0;
  gl_FragColor = vec4(mix(vec3(luma(c.rgb)), c.rgb, 1.0 + vibrance * (1.0 - saturation)), c.a);
}
