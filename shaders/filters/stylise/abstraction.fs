/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Simplifies the picture as the eye does: flat tones with soft steps, and lines",
  "CATEGORIES": ["Stylise"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "sigma", "TYPE": "float", "LABEL": "Sigma", "DEFAULT": 3, "MIN": 0.5, "MAX": 8},
    {"NAME": "range", "TYPE": "float", "LABEL": "Range", "DEFAULT": 4.25, "MIN": 1, "MAX": 20},
    {"NAME": "bins", "TYPE": "float", "LABEL": "Bins", "DEFAULT": 9, "MIN": 4, "MAX": 24},
    {"NAME": "lines", "TYPE": "float", "LABEL": "Lines", "DEFAULT": 1, "MIN": 0, "MAX": 1},
    {"NAME": "lineWidth", "TYPE": "float", "LABEL": "Line width", "DEFAULT": 1.4, "MIN": 0.5, "MAX": 3},
    {"NAME": "tau", "TYPE": "float", "LABEL": "Tau", "DEFAULT": 0.98, "MIN": 0.9, "MAX": 1},
    {"NAME": "phi", "TYPE": "float", "LABEL": "Phi", "DEFAULT": 2, "MIN": 0.1, "MAX": 8}
  ],
  "PASSES": [
    {"TARGET": "lab0", "FLOAT": true},
    {"TARGET": "lab1", "FLOAT": true},
    {"TARGET": "lab2", "FLOAT": true},
    {"TARGET": "lab3", "FLOAT": true},
    {"TARGET": "lab4", "FLOAT": true},
    {"TARGET": "lab5", "FLOAT": true},
    {"TARGET": "lab6", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil((6 * $sigma + 4 * $lineWidth) * $WIDTH / 640) + 20",
    "SAMPLING": "nearest",
    "UNIT": {"sigma": "px of 640", "range": "L*a*b*", "bins": "steps"},
    "TOOLTIP": {"sigma": "How far tones are made even", "range": "How different a neighbour may be", "bins": "Of lightness", "tau": "Higher: more lines", "phi": "Hardness of the lines"}
  }
}*/
vec3 lightFromCode(vec3 c) {
  return mix(c / 12.92, pow((max(c, 0.0) + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}
vec3 codeFromLight(vec3 c) {
  return mix(c * 12.92, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}
vec3 labFromCode(vec3 c) {
  vec3 xyz = lightFromCode(c) * mat3(0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505)
             / vec3(0.9505, 1.0, 1.089);
  vec3 f = mix(7.787 * xyz + 16.0 / 116.0, pow(max(xyz, 0.0), vec3(1.0 / 3.0)), greaterThan(xyz, vec3(0.008856)));
  return vec3(116.0 * f.y - 16.0, 500.0 * (f.x - f.y), 200.0 * (f.y - f.z));
}
vec3 codeFromLab(vec3 lab) {
  float y = (lab.x + 16.0) / 116.0;
  vec3 f = vec3(y + lab.y / 500.0, y, y - lab.z / 200.0);
  vec3 xyz = mix((f - 16.0 / 116.0) / 7.787, f * f * f, greaterThan(f, vec3(0.206893))) * vec3(0.9505, 1.0, 1.089);
  return codeFromLight(max(xyz * mat3(3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570), 0.0));
}
// Winnemoeller, Olsen and Gooch 2006: a bilateral filter in CIE L*a*b* with soft quantisation, and lines by DoG.
vec3 smoothed(vec3 here, vec2 direction, float sigma) {
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int reach = int(clamp(ceil(2.0 * sigma), 2.0, 64.0));
  for (int i = -reach; i <= reach; ++i) {
    vec2 p = gl_FragCoord.xy + direction * float(i);
    vec3 v = PASSINDEX == 1   ? IMG_PIXEL(lab0, p).rgb
             : PASSINDEX == 2 ? IMG_PIXEL(lab1, p).rgb
             : PASSINDEX == 3 ? IMG_PIXEL(lab2, p).rgb
             : PASSINDEX == 4 ? IMG_PIXEL(lab3, p).rgb
             : PASSINDEX == 5 ? IMG_PIXEL(lab4, p).rgb
                              : IMG_PIXEL(lab5, p).rgb;
    vec3 e = (v - here) / range;
    float x = float(i) / sigma;
    float w = exp(-0.5 * x * x - 0.5 * dot(e, e));
    sum += w * v;
    weights += w;
  }
  return sum / weights;
}
// Differences of Gaussians of lightness after the first smoothing; black where it falls below 0.
float line(float s) {
  vec2 sum = vec2(0.0), weights = vec2(0.0);
  int reach = int(clamp(ceil(4.0 * s), 2.0, 16.0));
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      float r2 = float(x * x + y * y);
      vec2 w = exp(-0.5 * r2 / vec2(s * s, 2.56 * s * s));
      sum += w * IMG_PIXEL(lab2, gl_FragCoord.xy + vec2(x, y)).r;
      weights += w;
    }
  vec2 g = sum / weights;
  float d = g.r - tau * g.g;
  return d > 0.0 ? 1.0 : 1.0 + tanh(phi * d);
}

void main() {
  float scale = IMG_SIZE(inputImage).x / 640.0;
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(labFromCode(IMG_THIS_PIXEL(inputImage).rgb), 1.0);
    return;
  }
  if (PASSINDEX < 7) {
    vec3 here = PASSINDEX == 1   ? IMG_THIS_PIXEL(lab0).rgb
                : PASSINDEX == 2 ? IMG_THIS_PIXEL(lab1).rgb
                : PASSINDEX == 3 ? IMG_THIS_PIXEL(lab2).rgb
                : PASSINDEX == 4 ? IMG_THIS_PIXEL(lab3).rgb
                : PASSINDEX == 5 ? IMG_THIS_PIXEL(lab4).rgb
                                 : IMG_THIS_PIXEL(lab5).rgb;
    bool across = PASSINDEX == 1 || PASSINDEX == 3 || PASSINDEX == 5;
    gl_FragColor = vec4(smoothed(here, across ? vec2(1.0, 0.0) : vec2(0.0, 1.0), max(sigma * scale, 0.6)), 1.0);
    return;
  }

  vec3 lab = IMG_THIS_PIXEL(lab6).rgb;
  // Soft steps of lightness, sharper where it changes fast.
  vec2 slope = vec2(IMG_PIXEL(lab6, gl_FragCoord.xy + vec2(1, 0)).r - IMG_PIXEL(lab6, gl_FragCoord.xy - vec2(1, 0)).r,
                    IMG_PIXEL(lab6, gl_FragCoord.xy + vec2(0, 1)).r - IMG_PIXEL(lab6, gl_FragCoord.xy - vec2(0, 1)).r);
  float sharp = mix(0.9, 1.6, clamp(0.5 * scale * length(slope) / 2.0, 0.0, 1.0));
  float width = 100.0 / bins, near = (floor(lab.x / width) + 0.5) * width;
  lab.x = near + 0.5 * width * tanh(sharp * (lab.x - near) / width * 3.0);
  vec3 c = codeFromLab(lab) * mix(1.0, line(max(0.5 * scale, 0.5) * lineWidth), lines);
  gl_FragColor = vec4(c, IMG_THIS_PIXEL(inputImage).a);
}
