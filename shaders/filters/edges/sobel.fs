/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Edges by the steepness of the tones",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "gain", "TYPE": "float", "LABEL": "Gain", "DEFAULT": 2, "MIN": 0, "MAX": 10}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 1,
    "SAMPLING": "nearest",
    "TOOLTIP": {"gain": "1: an edge from black to white is white"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
float at(int x, int y) { return grey(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb); }
vec2 gradient() {
  return vec2(at(1, 1) + 2.0 * at(1, 0) + at(1, -1) - at(-1, 1) - 2.0 * at(-1, 0) - at(-1, -1),
              at(1, 1) + 2.0 * at(0, 1) + at(-1, 1) - at(1, -1) - 2.0 * at(0, -1) - at(-1, -1));
}

void main() { gl_FragColor = vec4(vec3(gain * length(gradient()) * 0.25), IMG_THIS_PIXEL(inputImage).a); }
