/*{
  "ISFVSN": "2",
  "DESCRIPTION": "The frame number and the time, written into the picture",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "size", "TYPE": "float", "LABEL": "Size", "DEFAULT": 28, "MIN": 8, "MAX": 120},
    {"NAME": "timecode", "TYPE": "bool", "LABEL": "Timecode", "DEFAULT": true}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"size": "px of 1920"},
    "TOOLTIP": {"size": "Height of the digits", "timecode": "Hours, minutes, seconds, frames; off: the frame number"}
  }
}*/
// Digits of 3 x 5 dots, a number a digit; 10 is a colon.
int glyph(int d) {
  int g[11] = int[11](31599, 11415, 29671, 29647, 23497, 31183, 31215, 29257, 31727, 31695, 1040);
  return g[d];
}
float digit(int d, vec2 p) {
  if (p.x < 0.0 || p.y < 0.0 || p.x >= 3.0 || p.y >= 5.0) return 0.0;
  return float((glyph(d) >> (int(p.y) * 3 + 2 - int(p.x))) & 1);
}
int tens(int n, int i) {
  for (int k = 0; k < 10; ++k) if (k < i) n /= 10;
  return n % 10;
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float pixel = size * RENDERSIZE.x / 1920.0 / 5.0;
  vec2 p = (gl_FragCoord.xy - vec2(4.0 * pixel)) / pixel;
  float rate = max(floor(1.0 / max(TIMEDELTA, 1e-6) + 0.5), 1.0);
  int whole = int(floor(float(FRAMEINDEX) / rate)), rest = FRAMEINDEX - whole * int(rate);
  int number = FRAMEINDEX, on = 0;
  float ink = 0.0;
  for (int i = 0; i < 11; ++i) {  // HH:MM:SS:FF or the frame
    int d = timecode ? (i % 3 == 2 ? 10 : (i < 2 ? tens(whole / 3600, 1 - i) : i < 5 ? tens(whole / 60 % 60, 4 - i)
                                           : i < 8 ? tens(whole % 60, 7 - i) : tens(rest, 10 - i)))
                     : (i < 6 ? tens(number, 5 - i) : -1);
    if (d >= 0) ink = max(ink, digit(d, p - vec2(4.0 * float(i), 0.0)));
  }
  float box = timecode ? 43.0 : 23.0;
  bool inside = p.x > -2.0 && p.y > -2.0 && p.x < box + 2.0 && p.y < 7.0;
  gl_FragColor = vec4(inside ? mix(c.rgb * 0.25, vec3(1.0), ink) : c.rgb, c.a);
}
