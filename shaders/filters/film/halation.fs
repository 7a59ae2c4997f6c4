/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Red light around highlights, thrown back by the film base; no light is added",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.4, "MIN": 0, "MAX": 1},
    {"NAME": "threshold", "TYPE": "float", "LABEL": "Threshold", "DEFAULT": 0.8, "MIN": 0, "MAX": 20},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 14, "MIN": 1, "MAX": 80},
    {"NAME": "tint", "TYPE": "color", "LABEL": "Tint", "DEFAULT": [1, 0.22, 0.05, 1]}
  ],
  "PASSES": [
    {"TARGET": "narrow", "WIDTH": "ceil($WIDTH / max(1, floor($radius * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "bright", "WIDTH": "ceil($WIDTH / max(1, floor($radius * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($radius * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "across", "WIDTH": "ceil($WIDTH / max(1, floor($radius * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($radius * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "glow", "WIDTH": "ceil($WIDTH / max(1, floor($radius * $WIDTH / 3456)))", "HEIGHT": "ceil($HEIGHT / max(1, floor($radius * $WIDTH / 3456)))", "FLOAT": true},
    {"TARGET": "tall", "WIDTH": "ceil($WIDTH / max(1, floor($radius * $WIDTH / 3456)))", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(5.5 * $radius * $WIDTH / 1920) + 4",
    "SAMPLING": "nearest",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"amount": "The part of the bright light that is scattered", "threshold": "Light above this is scattered; 1 is white", "radius": "Standard deviation", "tint": "The part of each channel"}
  }
}*/
// What is above the threshold is scattered: taken from where it is, laid around it, channel by channel.
vec3 excess(vec3 c) { return max(c - threshold, 0.0); }

// A wide Gaussian is smooth: it is computed on a picture whose pixels are at most 0.55 of its standard
// deviation. On the way there a pixel is shared out between the two next to it, on the way back quadratic
// B-splines interpolate, first in one direction and then in the other.
vec2 ratio() { return IMG_SIZE(inputImage) / IMG_SIZE(glow); }  // pixels of the picture a pixel of it

// Mirrored at the frame's edges, so that there, too, no light is added.
vec2 inside(vec2 p, vec2 size) { return size - abs(size - abs(p)); }
vec3 source(vec2 p) {
  return PASSINDEX == 0   ? excess(IMG_PIXEL(inputImage, inside(p, IMG_SIZE(inputImage))).rgb)
         : PASSINDEX == 1 ? IMG_PIXEL(narrow, inside(p, IMG_SIZE(narrow))).rgb
         : PASSINDEX == 2 ? IMG_PIXEL(bright, inside(p, RENDERSIZE)).rgb
         : PASSINDEX == 3 ? IMG_PIXEL(across, inside(p, RENDERSIZE)).rgb
         : PASSINDEX == 4 ? IMG_PIXEL(glow, inside(p, IMG_SIZE(glow))).rgb
                          : IMG_PIXEL(tall, inside(p, IMG_SIZE(tall))).rgb;
}
vec2 along(float x) { return PASSINDEX == 0 || PASSINDEX == 2 || PASSINDEX == 5 ? vec2(x, gl_FragCoord.y) : vec2(gl_FragCoord.x, x); }
float along(vec2 p) { return PASSINDEX == 0 || PASSINDEX == 2 || PASSINDEX == 5 ? p.x : p.y; }

vec3 shrunk(float n) {
  if (n == 1.0) return source(gl_FragCoord.xy);
  float middle = along(gl_FragCoord.xy) * n;
  vec3 sum = vec3(0.0);
  for (float x = floor(middle - n) + 0.5; x < middle + n; ++x)
    sum += max(0.0, 1.0 - abs(x - middle) / n) * source(along(x));
  return sum / n;
}
// A Gaussian to three standard deviations. Its variance is less what sharing out, 1/6 + 1 / (12 n^2), and the
// B-spline, 1/4, add to it.
vec3 blurred(float n) {
  float sigma = radius * IMG_SIZE(inputImage).x / 1920.0;
  float variance = (sigma * sigma - (n > 1.0 ? 1.0 / 12.0 : 0.0)) / (n * n) - (n > 1.0 ? 5.0 / 12.0 : 0.0);
  int reach = int(min(ceil(3.0 * sqrt(variance)), 64.0));
  float middle = along(gl_FragCoord.xy);
  vec3 sum = source(gl_FragCoord.xy);
  float weights = 1.0;
  for (int i = 1; i <= reach; ++i) {
    float w = exp(-0.5 * float(i * i) / variance);
    sum += w * (source(along(middle - float(i))) + source(along(middle + float(i))));
    weights += 2.0 * w;
  }
  return sum / weights;
}
vec3 enlarged(float n) {
  if (n == 1.0) return source(gl_FragCoord.xy);
  float at = along(gl_FragCoord.xy) / n;
  float middle = floor(at) + 0.5;
  float f = at - middle;
  return 0.5 * (0.5 - f) * (0.5 - f) * source(along(middle - 1.0)) + (0.75 - f * f) * source(along(middle)) +
         0.5 * (0.5 + f) * (0.5 + f) * source(along(middle + 1.0));
}
void main() {
  float n = along(ratio());
  if (PASSINDEX < 5) {
    gl_FragColor = vec4(PASSINDEX < 2 ? shrunk(n) : PASSINDEX < 4 ? blurred(n) : enlarged(n), 1.0);
  } else {
    vec4 c = IMG_THIS_PIXEL(inputImage);
    gl_FragColor = vec4(c.rgb + amount * tint.rgb * (enlarged(n) - excess(c.rgb)), c.a);
  }
}
