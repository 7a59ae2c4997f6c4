/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Soft, evenly",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 6, "MIN": 0, "MAX": 60}
  ],
  "PASSES": [
    {"TARGET": "narrow", "WIDTH": "ceil($WIDTH / max(1, floor($sigma * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "small", "WIDTH": "ceil($WIDTH / max(1, floor($sigma * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($sigma * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "across", "WIDTH": "ceil($WIDTH / max(1, floor($sigma * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($sigma * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "soft", "WIDTH": "ceil($WIDTH / max(1, floor($sigma * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($sigma * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "tall", "WIDTH": "ceil($WIDTH / max(1, floor($sigma * $WIDTH / 3456)))", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(5.5 * $sigma * $WIDTH / 1920) + 4",
    "SAMPLING": "nearest",
    "UNIT": {"sigma": "px of 1920"},
    "TOOLTIP": {"sigma": "Standard deviation"}
  }
}*/
// A wide Gaussian is smooth: it is computed on a picture whose pixels are at most 0.55 of its standard
// deviation. On the way there a pixel is shared out between the two next to it, on the way back quadratic
// B-splines interpolate, first in one direction and then in the other.
vec2 ratio() { return IMG_SIZE(inputImage) / IMG_SIZE(soft); }  // pixels of the picture a pixel of it

// Mirrored at the frame's edges, so that no light comes or goes there.
vec2 inside(vec2 p, vec2 size) { return size - abs(size - abs(p)); }
vec4 source(vec2 p) {
  return PASSINDEX == 0   ? IMG_PIXEL(inputImage, inside(p, IMG_SIZE(inputImage)))
         : PASSINDEX == 1 ? IMG_PIXEL(narrow, inside(p, IMG_SIZE(narrow)))
         : PASSINDEX == 2 ? IMG_PIXEL(small, inside(p, RENDERSIZE))
         : PASSINDEX == 3 ? IMG_PIXEL(across, inside(p, RENDERSIZE))
         : PASSINDEX == 4 ? IMG_PIXEL(soft, inside(p, IMG_SIZE(soft)))
                          : IMG_PIXEL(tall, inside(p, IMG_SIZE(tall)));
}
vec2 along(float x) { return PASSINDEX == 0 || PASSINDEX == 2 || PASSINDEX == 5 ? vec2(x, gl_FragCoord.y) : vec2(gl_FragCoord.x, x); }
float along(vec2 p) { return PASSINDEX == 0 || PASSINDEX == 2 || PASSINDEX == 5 ? p.x : p.y; }

vec4 shrunk(float n) {
  if (n == 1.0) return source(gl_FragCoord.xy);
  float middle = along(gl_FragCoord.xy) * n;
  vec4 sum = vec4(0.0);
  for (float x = floor(middle - n) + 0.5; x < middle + n; ++x)
    sum += max(0.0, 1.0 - abs(x - middle) / n) * source(along(x));
  return sum / n;
}
// A Gaussian to three standard deviations. Its variance is less what sharing out, 1/6 + 1 / (12 n^2), and the
// B-spline, 1/4, add to it.
vec4 blurred(float n) {
  float s = sigma * IMG_SIZE(inputImage).x / 1920.0;
  float variance = (s * s - (n > 1.0 ? 1.0 / 12.0 : 0.0)) / (n * n) - (n > 1.0 ? 5.0 / 12.0 : 0.0);
  int reach = int(min(ceil(3.0 * sqrt(variance)), 64.0));
  float middle = along(gl_FragCoord.xy);
  vec4 sum = source(gl_FragCoord.xy);
  float weights = 1.0;
  for (int i = 1; i <= reach; ++i) {
    float w = exp(-0.5 * float(i * i) / variance);
    sum += w * (source(along(middle - float(i))) + source(along(middle + float(i))));
    weights += 2.0 * w;
  }
  return sum / weights;
}
vec4 enlarged(float n) {
  if (n == 1.0) return source(gl_FragCoord.xy);
  float at = along(gl_FragCoord.xy) / n;
  float middle = floor(at) + 0.5;
  float f = at - middle;
  return 0.5 * (0.5 - f) * (0.5 - f) * source(along(middle - 1.0)) + (0.75 - f * f) * source(along(middle)) +
         0.5 * (0.5 + f) * (0.5 + f) * source(along(middle + 1.0));
}
void main() {
  float n = along(ratio());
  gl_FragColor = PASSINDEX < 2 ? shrunk(n) : PASSINDEX < 4 ? blurred(n) : enlarged(n);
}
