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
    {"TARGET": "wide", "FLOAT": true},
    {}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(3 * $radius * $WIDTH / 1920) + 1",
    "UNIT": {"radius": "px of 1920"},
    "TOOLTIP": {"amount": "The part of the bright light that is scattered", "threshold": "Light above this is scattered; 1 is white", "radius": "Standard deviation", "tint": "The part of each channel"}
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

// What is above the threshold is scattered: taken from where it is, laid around it, channel by channel.
vec3 excess(vec3 c) { return max(c - threshold, 0.0); }
vec3 row(vec2 direction, float sigma, vec2 p) {
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int reach = int(clamp(ceil(2.0 * sigma), 4.0, 256.0));
  for (int i = -reach; i <= reach; ++i) {
    float x = 3.0 * float(i) / float(reach);  // to three standard deviations, in steps of 1.5 pixels
    float w = exp(-0.5 * x * x);
    vec2 at = p + direction * x * sigma;
    vec3 c = PASSINDEX == 0 ? excess(IMG_PIXEL(inputImage, at).rgb) : IMG_PIXEL(wide, at).rgb;
    sum += w * c;
    weights += w;
  }
  return sum / weights;
}
void main() {
  float sigma = radius * RENDERSIZE.x / 1920.0;
  if (PASSINDEX == 0) {
    gl_FragColor = vec4(row(vec2(1.0, 0.0), sigma, gl_FragCoord.xy), 1.0);
    return;
  }
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 glow = row(vec2(0.0, 1.0), sigma, gl_FragCoord.xy);
  gl_FragColor = vec4(c.rgb + amount * tint.rgb * (glow - excess(c.rgb)), c.a);
}
