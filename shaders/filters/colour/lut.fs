/*{
  "ISFVSN": "2",
  "DESCRIPTION": "A colour table (.cube) of a grade or a film",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "table", "TYPE": "image", "LABEL": "Table"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"table": "A .cube file, 3-D, made for display codes"}
  }
}*/
// The table lies as N * N x N pixels: red and green across, blue upwards. Tetrahedra would be finer; eight corners do.
vec3 entry(vec3 index, float n) { return IMG_PIXEL(table, vec2(index.g * n + index.r, index.b) + 0.5).rgb; }
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float n = IMG_SIZE(table).y;
  if (n < 2.0) {
    gl_FragColor = c;
    return;
  }
  vec3 p = clamp(c.rgb, 0.0, 1.0) * (n - 1.0);
  vec3 a = min(floor(p), n - 2.0), f = p - a;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 8; ++i) {
    vec3 corner = vec3(i & 1, (i >> 1) & 1, i >> 2);
    vec3 w = mix(1.0 - f, f, corner);
    sum += w.r * w.g * w.b * entry(a + corner, n);
  }
  gl_FragColor = vec4(mix(c.rgb, sum, amount), c.a);
}
