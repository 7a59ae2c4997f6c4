/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Glow around bright places, as in a lens: light is spread, none is added",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.12, "MIN": 0, "MAX": 1},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 14, "MIN": 2, "MAX": 60},
    {"NAME": "spread", "TYPE": "float", "LABEL": "Spread", "DEFAULT": 0.4, "MIN": 0, "MAX": 1}
  ],
  "PASSES": [
    {"TARGET": "small", "WIDTH": "min($WIDTH, 960)", "HEIGHT": "max(1, floor($HEIGHT * min(1, 960 / $WIDTH)))", "FLOAT": true},
    {"TARGET": "innerAcross", "WIDTH": "min($WIDTH, 960)", "HEIGHT": "max(1, floor($HEIGHT * min(1, 960 / $WIDTH)))", "FLOAT": true},
    {"TARGET": "inner", "WIDTH": "min($WIDTH, 960)", "HEIGHT": "max(1, floor($HEIGHT * min(1, 960 / $WIDTH)))", "FLOAT": true},
    {"TARGET": "outerAcross", "WIDTH": "min($WIDTH, 480)", "HEIGHT": "max(1, floor($HEIGHT * min(1, 480 / $WIDTH)))", "FLOAT": true},
    {"TARGET": "outer", "WIDTH": "min($WIDTH, 480)", "HEIGHT": "max(1, floor($HEIGHT * min(1, 480 / $WIDTH)))", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil((16 * $radius + 12) * $WIDTH / 1920) + 32",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"amount": "The part of all light that is spread", "radius": "Standard deviation of the inner glow; the outer one is four times as wide", "spread": "How much of it lies in the outer glow"}
  }
}*/
// Two Gaussians on smaller pictures of fixed size, so that the glow is the same at any resolution.
vec3 source(vec2 p) {
  return PASSINDEX == 1   ? IMG_NORM_PIXEL(small, p).rgb
         : PASSINDEX == 2 ? IMG_NORM_PIXEL(innerAcross, p).rgb
         : PASSINDEX == 3 ? IMG_NORM_PIXEL(inner, p).rgb
                          : IMG_NORM_PIXEL(outerAcross, p).rgb;
}
vec3 blurred(vec2 direction, float sigma) {
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = -16; i <= 16; ++i) {
    float x = float(i) / 5.33;
    float w = exp(-0.5 * x * x);
    sum += w * source((gl_FragCoord.xy + direction * x * sigma) / RENDERSIZE);
    weights += w;
  }
  return sum / weights;
}
// The mean of the pixels that one of a smaller picture covers.
vec3 shrunk() {
  vec2 ratio = IMG_SIZE(inputImage) / RENDERSIZE;
  int n = int(clamp(ceil(max(ratio.x, ratio.y)), 1.0, 16.0));
  vec3 sum = vec3(0.0);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x)
      sum += IMG_PIXEL(inputImage, (gl_FragCoord.xy - 0.5 + (vec2(x, y) + 0.5) / float(n)) * ratio).rgb;
  return sum / float(n * n);
}
void main() {
  float sigma = radius * RENDERSIZE.x / 1920.0;
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(shrunk(), 1.0);
  } else if (PASSINDEX < 5) {
    vec2 direction = PASSINDEX == 1 || PASSINDEX == 3 ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    gl_FragColor = vec4(blurred(direction, PASSINDEX < 3 ? sigma : 4.0 * sigma), 1.0);
  } else {
    vec4 c = IMG_THIS_PIXEL(inputImage);
    vec3 glow = mix(IMG_NORM_PIXEL(inner, isf_FragNormCoord).rgb, IMG_NORM_PIXEL(outer, isf_FragNormCoord).rgb, spread);
    gl_FragColor = vec4(mix(c.rgb, glow, amount), c.a);
  }
}
