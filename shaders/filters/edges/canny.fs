/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Thin, connected edges",
  "CATEGORIES": ["Edges"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "low", "TYPE": "float", "LABEL": "Low", "DEFAULT": 0.03, "MIN": 0, "MAX": 1},
    {"NAME": "high", "TYPE": "float", "LABEL": "High", "DEFAULT": 0.08, "MIN": 0, "MAX": 1}
  ],
  "PASSES": [
    {"TARGET": "slopes", "FLOAT": true},
    {"TARGET": "crests", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "HALO": 6,
    "SAMPLING": "nearest",
    "TOOLTIP": {"low": "Edges weaker than this are dropped", "high": "Edges stronger than this are kept"}
  }
}*/
float grey(vec3 c) { return dot(c, vec3(0.299, 0.587, 0.114)); }

// Canny 1986: a Gaussian, the gradient, only its crests, two thresholds; weak ones count beside strong ones.
float soft(ivec2 d) {
  float sum = 0.0, weights = 0.0;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      float w = exp(-0.5 * float(x * x + y * y) / 1.4);
      sum += w * grey(IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(ivec2(x, y) + d)).rgb);
      weights += w;
    }
  return sum / weights;
}
float steep(vec2 d) { return IMG_PIXEL(slopes, gl_FragCoord.xy + d).b; }
float crest(vec2 d) { return IMG_PIXEL(crests, gl_FragCoord.xy + d).r; }
void main() {
  if (PASSINDEX == 0) {
    vec2 g = vec2(soft(ivec2(1, 0)) - soft(ivec2(-1, 0)), soft(ivec2(0, 1)) - soft(ivec2(0, -1)));
    gl_FragColor = vec4(g, length(g), 1.0);
  } else if (PASSINDEX == 1) {
    vec3 g = IMG_THIS_PIXEL(slopes).rgb;
    vec2 n = g.b > 0.0 ? floor(g.rg / g.b * 1.3066 + 0.5) : vec2(0.0);  // to the nearest of eight neighbours
    float keep = g.b >= steep(n) && g.b > steep(-n) ? g.b : 0.0;
    gl_FragColor = vec4(keep);
  } else {
    float v = crest(vec2(0.0)), best = 0.0;
    for (int y = -2; y <= 2; ++y)
      for (int x = -2; x <= 2; ++x) best = max(best, crest(vec2(x, y)));
    float line = v >= high || (v >= low && best >= high) ? 1.0 : 0.0;
    gl_FragColor = vec4(vec3(line), 1.0);
  }
}
