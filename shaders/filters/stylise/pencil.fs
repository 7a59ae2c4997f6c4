/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Pencil drawing: tones divided by their blurred negative",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 6, "MIN": 1, "MAX": 15},
    {"NAME": "dark", "TYPE": "float", "LABEL": "Dark", "DEFAULT": 2.5, "MIN": 0.5, "MAX": 8},
    {"NAME": "color", "TYPE": "float", "LABEL": "Color", "DEFAULT": 0, "MIN": 0, "MAX": 1}
  ],
  "PASSES": [
    {"TARGET": "across", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": "ceil(3 * $sigma * $WIDTH / 1920) + 2",
    "SAMPLING": "nearest",
    "UNIT": {"sigma": "px of 1920"},
    "TOOLTIP": {"sigma": "Softness of the shading", "dark": "Pressure of the pencil", "color": "0: lead; 1: coloured pencils"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

float row(vec2 direction, float sigma) {
  float sum = 0.0, weights = 0.0;
  int reach = int(clamp(ceil(3.0 * sigma), 1.0, 48.0));
  for (int i = -reach; i <= reach; ++i) {
    float x = float(i), w = exp(-0.5 * x * x / (sigma * sigma));
    vec2 p = gl_FragCoord.xy + direction * x;
    sum += w * (PASSINDEX == 0 ? 1.0 - grey(IMG_PIXEL(inputImage, p).rgb) : IMG_PIXEL(across, p).r);
    weights += w;
  }
  return sum / weights;
}
void main() {
  float s = max(sigma * RENDERSIZE.x / 1920.0, 0.5);
  float soft = row(PASSINDEX == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0), s);
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(soft);
    return;
  }
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float v = pow(clamp(grey(c.rgb) / max(1.0 - soft, 0.01), 0.0, 1.0), dark);
  gl_FragColor = vec4(mix(vec3(v), min(c.rgb / max(grey(c.rgb), 0.05), 1.5) * v, color), c.a);
}
