/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Sharp in a band, blurred above and below: the set looks like a model",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "center", "TYPE": "float", "LABEL": "Center", "DEFAULT": 0.45, "MIN": 0, "MAX": 1},
    {"NAME": "band", "TYPE": "float", "LABEL": "Band", "DEFAULT": 0.15, "MIN": 0, "MAX": 1},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 18, "MIN": 0, "MAX": 60},
    {"NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DEFAULT": 0, "MIN": -90, "MAX": 90}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil($radius * $WIDTH / 1920) + 2",
    "UNIT": {"center": "of the height", "band": "of the width", "radius": "px of 1920", "angle": "degrees"},
    "TOOLTIP": {"center": "From below", "band": "Height of what is sharp"}
  }
}*/
void main() {
  vec2 p = isf_FragNormCoord - vec2(0.5, center);
  p.y *= RENDERSIZE.y / RENDERSIZE.x;
  float away = abs(dot(p, vec2(-sin(radians(angle)), cos(radians(angle)))));
  float amount = smoothstep(0.5 * band, 0.5 * band + 0.25, away);
  float reach = radius * amount * RENDERSIZE.x / 1920.0;
  vec3 sum = vec3(0.0);
  int places = int(clamp(reach * reach, 32.0, 1024.0));
  for (int i = 0; i < places; ++i) {
    float r = sqrt((float(i) + 0.5) / float(places)), a = float(i) * 2.39996323;
    sum += IMG_PIXEL(inputImage, gl_FragCoord.xy + r * reach * vec2(cos(a), sin(a))).rgb;
  }
  gl_FragColor = vec4(sum / float(places), IMG_THIS_PIXEL(inputImage).a);
}
