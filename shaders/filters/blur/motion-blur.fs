/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Smeared in one direction, as by a moving camera",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "way", "TYPE": "float", "LABEL": "Way", "DEFAULT": 30, "MIN": 0, "MAX": 300},
    {"NAME": "angle", "TYPE": "float", "LABEL": "Angle", "DEFAULT": 0, "MIN": -90, "MAX": 90}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil($way * $WIDTH / 3840) + 2",
    "UNIT": {"way": "px of 1920", "angle": "degrees"},
    "TOOLTIP": {"way": "How far the picture moves while the shutter is open"}
  }
}*/
void main() {
  float reach = way * RENDERSIZE.x / 1920.0;
  vec2 along = vec2(cos(radians(angle)), sin(radians(angle))) * reach;
  vec4 sum = vec4(0.0);
  int places = int(clamp(ceil(reach / 1.5), 16.0, 512.0));
  for (int i = 0; i < places; ++i)
    sum += IMG_PIXEL(inputImage, gl_FragCoord.xy + along * ((float(i) + 0.5) / float(places) - 0.5));
  gl_FragColor = sum / float(places);
}
