/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Silver left in the print: hard, pale and metallic",
  "CATEGORIES": ["Film"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 0.8, "MIN": 0, "MAX": 1},
    {"NAME": "contrast", "TYPE": "float", "LABEL": "Contrast", "DEFAULT": 0.45, "MIN": 0, "MAX": 1.5},
    {"NAME": "saturation", "TYPE": "float", "LABEL": "Saturation", "DEFAULT": 0.45, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
float luma(vec3 c) { return dot(c, vec3(0.2126, 0.7152, 0.0722)); }

void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 light = max(c.rgb, 0.0);
  float y = luma(light);
  // The silver's density is added to the dyes': a multiplication of light, about middle grey.
  vec3 silver = light * pow(max(y, 1e-6) / 0.18, contrast);
  silver = min(silver, max(light, 65504.0));  // what files hold
  silver = mix(vec3(luma(silver)), silver, saturation);
  gl_FragColor = vec4(mix(c.rgb, silver, amount), c.a);
}
