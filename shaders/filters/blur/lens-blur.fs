/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Out of focus: every point becomes a disc, highlights become bright discs",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 12, "MIN": 0, "MAX": 80},
    {"NAME": "blades", "TYPE": "float", "LABEL": "Blades", "DEFAULT": 0, "MIN": 0, "MAX": 12}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil($radius * $WIDTH / 1920) + 2",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"blades": "Below 3: round"}
  }
}*/
// Places on a disc by the golden angle (Vogel 1979), each standing for the same area.
void main() {
  float reach = radius * RENDERSIZE.x / 1920.0;
  vec3 sum = vec3(0.0);
  int places = int(clamp(reach * reach, 64.0, 1024.0));
  for (int i = 0; i < places; ++i) {
    float r = sqrt((float(i) + 0.5) / float(places)), a = float(i) * 2.39996323;
    // Towards a polygon of so many blades.
    float sector = 6.2831853 / max(blades, 3.0);
    float polygon = cos(0.5 * sector) / cos(mod(a, sector) - 0.5 * sector);
    vec2 d = r * (blades < 3.0 ? 1.0 : polygon) * vec2(cos(a), sin(a));
    sum += IMG_PIXEL(inputImage, gl_FragCoord.xy + d * reach).rgb;
  }
  gl_FragColor = vec4(sum / float(places), IMG_THIS_PIXEL(inputImage).a);
}
