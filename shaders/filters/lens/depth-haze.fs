/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Haze with distance, by a depth picture or, without one, with height in the frame",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "depth", "TYPE": "image", "LABEL": "Depth"},
    {"NAME": "density", "TYPE": "float", "LABEL": "Density", "DEFAULT": 1, "MIN": 0, "MAX": 8},
    {"NAME": "haze", "TYPE": "color", "LABEL": "Haze", "DEFAULT": [0.7, 0.8, 0.95, 1]},
    {"NAME": "light", "TYPE": "float", "LABEL": "Light", "DEFAULT": 0.6, "MIN": 0, "MAX": 20},
    {"NAME": "far", "TYPE": "bool", "LABEL": "Far", "DEFAULT": false}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "TOOLTIP": {"depth": "Black is near, white is far", "density": "1: at the far end 37 % of the picture is left", "light": "How bright the haze is; 1 is white", "far": "White is near in the depth picture"}
  }
}*/
// Koschmieder 1924: what is at distance d keeps exp(-density d), and the haze's light takes its place.
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float d = IMG_SIZE(depth).x > 1.5 ? IMG_NORM_PIXEL(depth, isf_FragNormCoord).r : isf_FragNormCoord.y;
  float kept = exp(-density * max(far ? 1.0 - d : d, 0.0));
  gl_FragColor = vec4(mix(haze.rgb * light, c.rgb, kept), c.a);
}
