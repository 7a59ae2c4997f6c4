/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Coloured tiles",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "tiles", "TYPE": "float", "LABEL": "Tiles", "DEFAULT": 80, "MIN": 8, "MAX": 480},
    {"NAME": "grout", "TYPE": "float", "LABEL": "Grout", "DEFAULT": 0.06, "MIN": 0, "MAX": 0.5}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil($WIDTH / $tiles) + 2",
    "SAMPLING": "nearest",
    "UNIT": {"tiles": "tiles"},
    "TOOLTIP": {"tiles": "Across the picture", "grout": "Width of the joints"}
  }
}*/
void main() {
  float cell = max(1.0, floor(RENDERSIZE.x / tiles + 0.5));
  vec2 corner = floor(gl_FragCoord.xy / cell) * cell;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 64; ++i) {  // an even sample of the tile
    vec2 at = corner + (vec2(i % 8, i / 8) + 0.5) / 8.0 * cell;
    sum += IMG_PIXEL(inputImage, clamp(at, vec2(0.5), RENDERSIZE - 0.5));
  }
  vec2 d = abs(gl_FragCoord.xy - corner - 0.5 * cell) / (0.5 * cell);
  float gap = step(1.0 - grout, max(d.x, d.y));
  gl_FragColor = vec4(sum.rgb / 64.0 * (1.0 - 0.8 * gap), sum.a / 64.0);
}
