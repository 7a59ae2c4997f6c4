/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The tones as a relief, lit from one side",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "height", "TYPE": "float", "LABEL": "Height", "DEFAULT": 3, "MIN": 0, "MAX": 20},
    {"NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DEFAULT": 135, "MIN": -180, "MAX": 180},
    {"NAME": "color", "TYPE": "float", "LABEL": "Color", "DEFAULT": 0, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 1,
    "SAMPLING": "nearest",
    "UNIT": {"angle": "degrees"},
    "TOOLTIP": {"angle": "Where the light comes from", "color": "How much of the colour stays"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }
float at(int x, int y) { return grey(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(x, y)).rgb); }

void main() {
  vec2 d = vec2(at(1, 0) - at(-1, 0), at(0, 1) - at(0, -1));
  float v = 0.5 + 0.5 * height * dot(d, vec2(cos(radians(angle)), sin(radians(angle))));
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(mix(vec3(v), c.rgb * v * 2.0, color), c.a);
}
