/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Slide film in the wrong bath: green shadows, yellow highlights",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.8, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
vec3 curve(vec3 v, vec3 contrast) {
  vec3 s = v * v * (3.0 - 2.0 * v);
  return mix(v, s, contrast);
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 v = clamp(c.rgb, 0.0, 1.0);
  vec3 crossed = curve(v, vec3(1.1, 0.9, 0.1));
  crossed.b = 0.15 + crossed.b * 0.62;
  crossed.g = min(crossed.g * 1.06, 1.0);
  gl_FragColor = vec4(mix(c.rgb, crossed, amount), c.a);
}
