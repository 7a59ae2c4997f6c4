/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Turned left to right, or upside down",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "leftRight", "TYPE": "bool", "LABEL": "Left right", "DEFAULT": true},
    {"NAME": "upDown", "TYPE": "bool", "LABEL": "Up down", "DEFAULT": false}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "SAMPLING": "nearest",
    "TOOLTIP": {"leftRight": "As in a mirror", "upDown": "Upside down"}
  }
}*/
void main() {
  vec2 p = gl_FragCoord.xy;
  if (leftRight) p.x = RENDERSIZE.x - p.x;
  if (upDown) p.y = RENDERSIZE.y - p.y;
  gl_FragColor = IMG_PIXEL(inputImage, p);
}
