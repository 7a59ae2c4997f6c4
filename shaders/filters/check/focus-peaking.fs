/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Marks what is sharp",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "threshold", "TYPE": "float", "LABEL": "Threshold", "DEFAULT": 0.06, "MIN": 0.005, "MAX": 0.5},
    {"NAME": "color", "TYPE": "color", "LABEL": "Color", "DEFAULT": [1, 0.15, 0.1, 1]},
    {"NAME": "grey", "TYPE": "bool", "LABEL": "Grey", "DEFAULT": true}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 2,
    "SAMPLING": "nearest",
    "TOOLTIP": {"grey": "The picture in grey behind the marks"}
  }
}*/
float at(int x, int y) { return dot(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb, vec3(0.299, 0.587, 0.114)); }
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  // Fine detail (one pixel) against coarse (two pixels): a soft edge, however strong, is not marked.
  float fine = abs(4.0 * at(0, 0) - at(1, 0) - at(-1, 0) - at(0, 1) - at(0, -1));
  float coarse = abs(4.0 * at(0, 0) - at(2, 0) - at(-2, 0) - at(0, 2) - at(0, -2));
  float sharp = smoothstep(threshold, 2.0 * threshold + 0.001, fine - 0.25 * coarse);
  vec3 base = grey ? vec3(at(0, 0)) : c.rgb;
  gl_FragColor = vec4(mix(base, color.rgb, sharp), c.a);
}
