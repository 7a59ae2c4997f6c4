/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Takes a coloured screen out: matte, spill, and a picture behind",
  "CATEGORIES": ["Key"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "key", "TYPE": "color", "LABEL": "Key", "DEFAULT": [0.1, 0.7, 0.2, 1]},
    {"NAME": "inner", "TYPE": "float", "LABEL": "Inner", "DEFAULT": 0.12, "MIN": 0, "MAX": 1},
    {"NAME": "outer", "TYPE": "float", "LABEL": "Outer", "DEFAULT": 0.22, "MIN": 0, "MAX": 1},
    {"NAME": "spill", "TYPE": "float", "LABEL": "Spill", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "plate", "TYPE": "image", "LABEL": "Plate"},
    {"NAME": "background", "TYPE": "color", "LABEL": "Background", "DEFAULT": [0.12, 0.13, 0.16, 1]},
    {"NAME": "plateStops", "TYPE": "float", "LABEL": "Plate stops", "DEFAULT": 0, "MIN": -6, "MAX": 6},
    {"NAME": "plateBlur", "TYPE": "float", "LABEL": "Plate blur", "DEFAULT": 0, "MIN": 0, "MAX": 40},
    {"NAME": "show", "TYPE": "long", "LABEL": "Show", "VALUES": [0, 1, 2], "LABELS": ["the composite", "the matte", "the foreground with alpha"], "DEFAULT": 0}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "WHERE": ["shot", "light", "frame"],
    "UNIT": {"plateStops": "stops", "plateBlur": "px of 1920"},
    "TOOLTIP": {"key": "The colour of the screen", "inner": "Nearer than this is all screen", "outer": "Further than this is all foreground", "spill": "Takes the screen's light off the foreground", "plate": "The picture behind; without one a colour"}
  }
}*/
// a = clamp((distance - inner) / (outer - inner)) in the plane of Cb and Cr; spill is limited; over the plate.
vec2 chroma(vec3 c) {
  float y = dot(c, vec3(0.299, 0.587, 0.114));
  return vec2((c.b - y) / 1.772, (c.r - y) / 1.402);
}
vec3 plateAt(vec2 p) {
  vec2 size = IMG_SIZE(plate);
  if (size.x < 1.5) return background.rgb;
  vec2 scaled = (p - 0.5) * RENDERSIZE / size / max(RENDERSIZE.x / size.x, RENDERSIZE.y / size.y) + 0.5;  // fills
  vec3 sum = vec3(0.0);
  float reach = plateBlur * size.x / 1920.0;
  int places = plateBlur > 0.0 ? 48 : 1;
  for (int i = 0; i < places; ++i) {
    float r = plateBlur > 0.0 ? sqrt((float(i) + 0.5) / 48.0) * reach : 0.0, a = float(i) * 2.39996323;
    sum += IMG_NORM_PIXEL(plate, scaled + r * vec2(cos(a), sin(a)) / size).rgb;
  }
  return sum / float(places);
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float matte = clamp((distance(chroma(c.rgb), chroma(key.rgb)) - inner) / max(outer - inner, 0.001), 0.0, 1.0) * c.a;
  vec3 front = c.rgb;
  bool green = key.g >= key.b;
  if (green) front.g = mix(front.g, min(front.g, 0.5 * (front.r + front.b)), spill);
  if (!green) front.b = mix(front.b, min(front.b, 0.5 * (front.r + front.g)), spill);
  // Exposure is of light: a power of two there is this factor of codes by the 2.2 curve.
  vec3 behind = clamp(plateAt(isf_FragNormCoord) * exp2(plateStops / 2.2), 0.0, 1.0);
  gl_FragColor = show == 1 ? vec4(vec3(matte), 1.0)
                 : show == 2 ? vec4(front, matte)
                             : vec4(mix(behind, front, matte), 1.0);
}
