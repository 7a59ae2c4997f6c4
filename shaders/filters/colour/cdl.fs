/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The ASC colour decision list: slope, offset, power and saturation",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "slope", "TYPE": "color", "LABEL": "Slope", "DEFAULT": [1, 1, 1, 1]},
    {"NAME": "offset", "TYPE": "color", "LABEL": "Offset", "DEFAULT": [0.5, 0.5, 0.5, 1]},
    {"NAME": "power", "TYPE": "color", "LABEL": "Power", "DEFAULT": [0.5, 0.5, 0.5, 1]},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 1, "MIN": 0, "MAX": 4}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"slope": "A factor a channel", "offset": "Added a channel: 0.5 adds nothing", "power": "Half of the exponent a channel: 0.5 changes nothing", "saturation": "1 changes nothing"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// ASC CDL 1.2: out = (in * slope + offset) ^ power, then saturation about Rec.709 luminance. Without the clamp at 1.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 v = c.rgb * slope.rgb + offset.rgb - 0.5;
  v = pow(max(v, 0.0), power.rgb * 2.0) + min(v, 0.0);
  gl_FragColor = vec4(mix(vec3(luma(v)), v, saturation), c.a);
}
