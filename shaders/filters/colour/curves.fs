/*{
  "ISFVSN": "2",
  "DESCRIPTION": "A tone curve through five points",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "black", "TYPE": "float", "LABEL": "Black", "DEFAULT": 0, "MIN": 0, "MAX": 1},
    {"NAME": "shadows", "TYPE": "float", "LABEL": "Shadows", "DEFAULT": 0.2, "MIN": 0, "MAX": 1},
    {"NAME": "middle", "TYPE": "float", "LABEL": "Middle", "DEFAULT": 0.5, "MIN": 0, "MAX": 1},
    {"NAME": "highlights", "TYPE": "float", "LABEL": "Highlights", "DEFAULT": 0.8, "MIN": 0, "MAX": 1},
    {"NAME": "white", "TYPE": "float", "LABEL": "White", "DEFAULT": 1, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "TOOLTIP": {"black": "What 0 becomes", "shadows": "What 0.25 becomes", "middle": "What 0.5 becomes", "highlights": "What 0.75 becomes", "white": "What 1 becomes"}
  }
}*/
// A monotone cubic (Fritsch and Carlson 1980) through five evenly spaced points.
float slopeOf(float before, float at, float after) {
  float a = at - before, b = after - at;
  return a * b <= 0.0 ? 0.0 : 2.0 * a * b / (a + b);
}
float curve(float x) {
  float p[5] = float[5](black, shadows, middle, highlights, white);
  int i = int(clamp(floor(x * 4.0), 0.0, 3.0));
  float t = clamp(x * 4.0 - float(i), 0.0, 1.0);
  float left = i == 0 ? p[1] - p[0] : slopeOf(p[max(i - 1, 0)], p[i], p[i + 1]);
  float right = i == 3 ? p[4] - p[3] : slopeOf(p[i], p[i + 1], p[min(i + 2, 4)]);
  float u = 1.0 - t;
  return p[i] * (1.0 + 2.0 * t) * u * u + left * t * u * u + p[i + 1] * t * t * (3.0 - 2.0 * t) - right * t * t * u;
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  gl_FragColor = vec4(curve(c.r), curve(c.g), curve(c.b), c.a);
}
