/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Fits bright light into the range of a display: Reinhard with a white point",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "white", "TYPE": "float", "LABEL": "White", "DEFAULT": 8, "MIN": 1, "MAX": 100}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"white": "The light that becomes white"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// Reinhard et al. 2002, equation 4, on luminance: colours keep their hue.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float y = luma(c.rgb);
  float scale = y > 0.0 ? (1.0 + y / (white * white)) / (1.0 + y) : 1.0;
  gl_FragColor = vec4(c.rgb * scale, c.a);
}
