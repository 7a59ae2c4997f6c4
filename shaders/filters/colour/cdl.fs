/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The ASC colour decision list: slope, offset, power and saturation",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 1, "MIN": 0, "MAX": 4}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "INPUTS": [
      {"NAME": "slopes", "TYPE": "vector", "LABEL": "Slope", "DEFAULT": [1, 1, 1], "MIN": 0, "MAX": 4},
      {"NAME": "offsets", "TYPE": "vector", "LABEL": "Offset", "DEFAULT": [0, 0, 0], "MIN": -2, "MAX": 2},
      {"NAME": "powers", "TYPE": "vector", "LABEL": "Power", "DEFAULT": [1, 1, 1], "MIN": 0, "MAX": 2}
    ],
    "TOOLTIP": {"slopes": "A factor for red, green and blue", "offsets": "What is added to each", "powers": "The exponent of each", "saturation": "1 changes nothing"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// ASC CDL 1.2: out = (in * slope + offset) ^ power, then saturation about Rec.709 luminance. Without the clamp at 1.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 v = c.rgb * slopes + offsets;
  v = pow(max(v, 0.0), powers) + min(v, 0.0);
  gl_FragColor = vec4(mix(vec3(luma(v)), v, saturation), c.a);
}
