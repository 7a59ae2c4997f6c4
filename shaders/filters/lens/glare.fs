/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Rays from highlights, as a star filter before the lens; no light is added",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.5, "MIN": 0, "MAX": 1},
    {"NAME": "threshold", "TYPE": "float", "LABEL": "Threshold", "DEFAULT": 1, "MIN": 0, "MAX": 50},
    {"NAME": "way", "TYPE": "float", "LABEL": "Way", "DEFAULT": 120, "MIN": 5, "MAX": 600},
    {"NAME": "rays", "TYPE": "float", "LABEL": "Rays", "DEFAULT": 4, "MIN": 2, "MAX": 12},
    {"NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DEFAULT": 25, "MIN": -90, "MAX": 90}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil($way * $WIDTH / 1920) + 2",
    "UNIT": {"way": "px of 1920", "angle": "degrees"},
    "TOOLTIP": {"amount": "The part of the bright light that goes into rays", "threshold": "Light above this; 1 is white", "way": "Length of a ray", "rays": "2 is a streak, 4 a cross"}
  }
}*/
vec3 excess(vec3 c) { return max(c - threshold, 0.0); }
// The ray that reaches this pixel along a direction: falls off exponentially, sums to one.
vec3 ray(vec2 direction, float reach) {
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int i = -60; i <= 60; ++i) {
    float t = float(i) / 60.0, w = exp(-4.0 * abs(t));
    sum += w * excess(IMG_PIXEL(inputImage, gl_FragCoord.xy + direction * t * reach).rgb);
    weights += w;
  }
  return sum / weights;
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float reach = way * RENDERSIZE.x / 1920.0;
  vec3 sum = vec3(0.0);
  float lines = floor(rays * 0.5 + 0.5);
  for (int i = 0; i < 6; ++i) {
    if (float(i) >= lines) break;
    float a = radians(angle) + 3.14159265 * float(i) / lines;
    sum += ray(vec2(cos(a), sin(a)), reach) / lines;
  }
  gl_FragColor = vec4(c.rgb + amount * (sum - excess(c.rgb)), c.a);
}
