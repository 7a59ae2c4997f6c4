/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Brightness, contrast, saturation and sharpness as photo programs mean them: 1 changes nothing",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "brightness", "TYPE": "float", "LABEL": "Brightness", "DEFAULT": 1, "MIN": 0, "MAX": 3},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 1, "MIN": 0, "MAX": 3},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 1, "MIN": 0, "MAX": 3},
    {"NAME": "sharpness", "TYPE": "float", "LABEL": "Sharpness", "DEFAULT": 1, "MIN": 0, "MAX": 3}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 1,
    "SAMPLING": "nearest",
    "OVERVIEW": "overview",
    "TOOLTIP": {"contrast": "About the mean grey of the frame", "sharpness": "0 is soft"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

// The Python Imaging Library's ImageEnhance: away from black, the mean grey, the pixel's grey, the 3 x 3 smooth.
vec3 at(int x, int y) { return IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb; }
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 soft = 5.0 * c.rgb;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      if (x != 0 || y != 0) soft += at(x, y);
  vec3 v = mix(soft / 13.0, c.rgb, sharpness) * brightness;
  float mean = 0.0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) mean += grey(IMG_NORM_PIXEL(overview, (vec2(x, y) + 0.5) / 16.0).rgb) / 256.0;
  v = mix(vec3(mean * brightness), v, contrast);
  gl_FragColor = vec4(mix(vec3(grey(v)), v, saturation), c.a);
}
