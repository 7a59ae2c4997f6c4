/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Lays a picture with alpha over the frame: a CG element, a title",
  "CATEGORIES": ["Key"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "element", "TYPE": "image", "LABEL": "Element"},
    {"NAME": "position", "TYPE": "point2D", "LABEL": "Position", "DEFAULT": [0.5, 0.5], "MIN": [-1, -1], "MAX": [2, 2]},
    {"NAME": "scale", "TYPE": "float", "LABEL": "Scale", "DEFAULT": 1, "MIN": 0.01, "MAX": 4},
    {"NAME": "opacity", "TYPE": "float", "LABEL": "Opacity", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "stops", "TYPE": "float", "LABEL": "Stops", "DEFAULT": 0, "MIN": -8, "MAX": 8},
    {"NAME": "premultiplied", "TYPE": "bool", "LABEL": "Premultiplied", "DEFAULT": true}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "UNIT": {"position": "of the frame", "scale": "of the width", "stops": "stops"},
    "TOOLTIP": {"element": "R, G, B and alpha", "position": "Of its middle", "premultiplied": "Its colour is multiplied by its alpha already, as in EXR"}
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec2 size = IMG_SIZE(element);
  if (size.x < 1.5) {
    gl_FragColor = c;
    return;
  }
  vec2 whole = RENDERSIZE.x * scale * vec2(1.0, size.y / size.x);
  vec2 p = (gl_FragCoord.xy - position * RENDERSIZE) / whole + 0.5;
  vec4 e = IMG_NORM_PIXEL(element, p);
  bool inside = all(greaterThanEqual(p, vec2(0.0))) && all(lessThanEqual(p, vec2(1.0)));
  float a = inside ? e.a * opacity : 0.0;
  vec3 light = e.rgb * exp2(stops) * (premultiplied ? opacity : a);
  gl_FragColor = inside ? vec4(light + c.rgb * (1.0 - a), a + c.a * (1.0 - a)) : c;
}
