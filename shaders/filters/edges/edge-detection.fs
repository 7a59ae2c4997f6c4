/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Dark lines on white: Sobel, then a threshold",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "threshold", "TYPE": "float", "LABEL": "Threshold", "DEFAULT": 0.12, "MIN": 0, "MAX": 1},
    {"NAME": "softness", "TYPE": "float", "LABEL": "Softness", "DEFAULT": 0.03, "MIN": 0, "MAX": 0.5},
    {"NAME": "white", "TYPE": "bool", "LABEL": "White", "DEFAULT": false}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 1,
    "SAMPLING": "nearest",
    "TOOLTIP": {"white": "White lines on black"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
float at(int x, int y) { return grey(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb); }
vec2 gradient() {
  return vec2(at(1, 1) + 2.0 * at(1, 0) + at(1, -1) - at(-1, 1) - 2.0 * at(-1, 0) - at(-1, -1),
              at(1, 1) + 2.0 * at(0, 1) + at(-1, 1) - at(1, -1) - 2.0 * at(0, -1) - at(-1, -1));
}

void main() {
  float e = length(gradient()) * 0.25;
  float line = smoothstep(threshold - softness, threshold + softness + 0.001, e);
  gl_FragColor = vec4(vec3(white ? line : 1.0 - line), IMG_THIS_PIXEL(inputImage).a);
}
