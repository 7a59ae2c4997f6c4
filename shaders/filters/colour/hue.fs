/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Turns every hue around the colour circle; luminance stays",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "turn", "TYPE": "float", "LABEL": "Turn", "DEFAULT": 30, "MIN": -180, "MAX": 180}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"turn": "degrees"},
    "TOOLTIP": {"turn": "120 makes red green"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float angle = radians(turn);
  // A turn about the grey axis, then the luminance put back.
  vec3 axis = vec3(0.57735027);
  vec3 turned = c.rgb * cos(angle) + cross(axis, c.rgb) * sin(angle) + axis * dot(axis, c.rgb) * (1.0 - cos(angle));
  gl_FragColor = vec4(turned + luma(c.rgb) - luma(turned), c.a);
}
