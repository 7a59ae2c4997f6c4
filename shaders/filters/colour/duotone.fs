/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Dark tones in one colour, bright ones in another",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "dark", "TYPE": "color", "LABEL": "Dark", "DEFAULT": [0.08, 0.05, 0.25, 1]},
    {"NAME": "bright", "TYPE": "color", "LABEL": "Bright", "DEFAULT": [1, 0.9, 0.65, 1]}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(mix(dark.rgb, bright.rgb, grey(c.rgb)), c.a);
}
