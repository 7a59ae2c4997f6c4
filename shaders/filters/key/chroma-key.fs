/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Takes a coloured screen out: matte, spill, and a picture behind",
  "CATEGORIES": ["Key"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "key", "TYPE": "color", "LABEL": "Key", "DEFAULT": [0.1, 0.7, 0.2, 1]},
    {"NAME": "underWhite", "TYPE": "bool", "LABEL": "As under white", "DEFAULT": true},
    {"NAME": "inner", "TYPE": "float", "LABEL": "Inner", "DEFAULT": 0.12, "MIN": 0, "MAX": 1},
    {"NAME": "outer", "TYPE": "float", "LABEL": "Outer", "DEFAULT": 0.22, "MIN": 0, "MAX": 1},
    {"NAME": "spill", "TYPE": "float", "LABEL": "Spill", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "plate", "TYPE": "image", "LABEL": "Plate"},
    {"NAME": "background", "TYPE": "color", "LABEL": "Background", "DEFAULT": [0.12, 0.13, 0.16, 1]},
    {"NAME": "plateStops", "TYPE": "float", "LABEL": "Plate stops", "DEFAULT": 0, "MIN": -6, "MAX": 6},
    {"NAME": "plateBlur", "TYPE": "float", "LABEL": "Plate blur", "DEFAULT": 0, "MIN": 0, "MAX": 40},
    {"NAME": "plateLight", "TYPE": "float", "LABEL": "Lit by the set", "DEFAULT": 0, "MIN": 0, "MAX": 1},
    {"NAME": "show", "TYPE": "long", "LABEL": "Show", "VALUES": [0, 1, 2], "LABELS": ["the composite", "the matte", "the foreground with alpha"], "DEFAULT": 0}
  ],
  "PASSES": [{"TARGET": "screenLight", "WIDTH": "48", "HEIGHT": "32", "FLOAT": true}, {}],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": "ceil($plateLight) * ceil(0.1 * $WIDTH + $WIDTH / 48 + $HEIGHT / 32)",
    "LIGHT": "setLight",
    "WHERE": ["shot", "light", "frame"],
    "UNIT": {"plateStops": "stops", "plateBlur": "px of 1920"},
    "TOOLTIP": {"key": "The colour of the screen, as a monitor shows it", "underWhite": "The key is pulled as if all lights were at unit white, so that it holds whatever the lights become (where they are known: not on a frame alone)", "inner": "Nearer than this is all screen", "outer": "Further than this is all foreground", "spill": "Takes the screen's light off the foreground", "plate": "The picture behind; without one a colour", "plateLight": "0: as it was photographed. 1: the set's lights light it as they do the screen before it; with all lights at unit white nothing changes"}
  }
}*/
// Matte = clamp((distance - inner) / (outer - inner)) in the plane of Cb and Cr of sRGB codes; spill is limited;
// foreground and plate are mixed in light.
vec3 codesOf(vec3 light) {
  vec3 c = clamp(light, 0.0, 1.0);
  return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
vec3 lightOf(vec3 codes) {
  return mix(codes / 12.92, pow((codes + 0.055) / 1.055, vec3(2.4)), step(0.04045, codes));
}
vec2 chroma(vec3 c) {
  float y = dot(c, vec3(0.299, 0.587, 0.114));
  return vec2((c.b - y) / 1.772, (c.r - y) / 1.402);
}
// How much more light the lights give at a place than at unit white.
vec3 lightAt(vec2 place) {
  return IMG_SIZE(setLight).x < 1.5 ? vec3(1.0) : max(IMG_NORM_PIXEL(setLight, place).rgb, 0.0001);
}
float matteOf(vec4 c, vec2 place) {
  vec3 codes = codesOf(underWhite ? c.rgb / lightAt(place) : c.rgb);
  return clamp((distance(chroma(codes), chroma(key.rgb)) - inner) / max(outer - inner, 0.001), 0.0, 1.0) * c.a;
}
// How much more light than at unit white falls on the screen around a place: what stands before it counts as
// good as nothing, so that a red light on a face reddens no plate beside it.
vec3 lightOnScreen(vec2 place) {
  if (plateLight <= 0.0) return vec3(1.0);
  vec2 reach = 0.1 * vec2(1.0, IMG_SIZE(inputImage).x / IMG_SIZE(inputImage).y);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 160; ++i) {
    float r = sqrt((float(i) + 0.5) / 160.0), a = float(i) * 2.39996323;
    vec2 p = clamp(place + r * reach * vec2(cos(a), sin(a)), 0.0, 1.0);
    float weight = exp(-3.0 * r * r) * (1.0 - matteOf(IMG_NORM_PIXEL(inputImage, p), p)) + 0.00001;
    sum += weight * vec4(lightAt(p), 1.0);
  }
  return sum.rgb / sum.a;
}
vec3 plateAt(vec2 p) {
  vec2 size = IMG_SIZE(plate);
  if (size.x < 1.5) return lightOf(background.rgb);
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
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(lightOnScreen(isf_FragNormCoord), 1.0);
    return;
  }
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float matte = matteOf(c, isf_FragNormCoord);
  vec3 front = c.rgb;
  bool green = key.g >= key.b;
  if (green) front.g = mix(front.g, min(front.g, 0.5 * (front.r + front.b)), spill);
  if (!green) front.b = mix(front.b, min(front.b, 0.5 * (front.r + front.g)), spill);
  vec3 light = mix(vec3(1.0), IMG_NORM_PIXEL(screenLight, isf_FragNormCoord).rgb, plateLight);
  vec3 behind = plateAt(isf_FragNormCoord) * light * exp2(plateStops);
  gl_FragColor = show == 1 ? vec4(lightOf(vec3(matte)), 1.0)
                 : show == 2 ? vec4(front, matte)
                             : vec4(mix(behind, front, matte), 1.0);
}
