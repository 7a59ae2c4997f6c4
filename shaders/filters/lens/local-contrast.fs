/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Clarity: brings out shapes of middle size, without halos at highlights",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.5, "MIN": -1, "MAX": 2},
    {"NAME": "radius", "TYPE": "float", "LABEL": "Radius", "DEFAULT": 40, "MIN": 4, "MAX": 100}
  ],
  "PASSES": [
    {"TARGET": "across", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(3 * $radius * $WIDTH / 1920) + 2",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"amount": "Below 0: softer"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// On log luminance: how far a place lies above its surroundings, made larger; strong edges are left alone.
float stopsAt(vec2 p) { return log2(max(luma(IMG_PIXEL(inputImage, p).rgb), 1e-4)); }
float row(vec2 direction, float sigma, float here) {
  float sum = 0.0, weights = 0.0;
  for (int i = -24; i <= 24; ++i) {
    float x = float(i) / 8.0;
    vec2 p = gl_FragCoord.xy + direction * x * sigma;
    float v = PASSINDEX == 0 ? stopsAt(p) : IMG_PIXEL(across, p).r;
    float e = (v - here) / 1.5;
    float w = exp(-0.5 * x * x - 0.5 * e * e);
    sum += w * v;
    weights += w;
  }
  return sum / weights;
}
void main() {
  float s = radius * RENDERSIZE.x / 1920.0;
  float here = stopsAt(gl_FragCoord.xy);
  float soft = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s, here);
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float change = clamp(amount * (here - soft), -2.0, 2.0);
  gl_FragColor = PASSINDEX == 0 ? vec4(soft) : vec4(c.rgb * exp2(change), c.a);
}
