/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Edges and points by the curvature of the tones",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "gain", "TYPE": "float", "LABEL": "Gain", "DEFAULT": 4, "MIN": 0, "MAX": 20},
    {"NAME": "middle", "TYPE": "bool", "LABEL": "Middle", "DEFAULT": false}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 1,
    "SAMPLING": "nearest",
    "TOOLTIP": {"middle": "Grey where it is flat, so that the sign is seen"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
float at(int x, int y) { return grey(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb); }

void main() {
  float v = at(1, 0) + at(-1, 0) + at(0, 1) + at(0, -1) - 4.0 * at(0, 0);
  gl_FragColor = vec4(vec3(middle ? 0.5 + 0.25 * gain * v : gain * abs(v) * 0.25), IMG_THIS_PIXEL(inputImage).a);
}
