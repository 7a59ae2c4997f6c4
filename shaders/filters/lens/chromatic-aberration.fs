/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Red and blue are not quite as large as green: coloured edges towards the corners",
  "CATEGORIES": ["Lens"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 2, "MIN": -20, "MAX": 20}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": "ceil(abs($amount) * $WIDTH / 960) + 2",
    "UNIT": {"amount": "px of 1920"},
    "TOOLTIP": {"amount": "At the left and right edge"}
  }
}*/
void main() {
  vec2 p = gl_FragCoord.xy - 0.5 * RENDERSIZE;
  float k = 2.0 * amount / 1920.0;
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float r = IMG_PIXEL(inputImage, gl_FragCoord.xy + p * k).r;
  float b = IMG_PIXEL(inputImage, gl_FragCoord.xy - p * k).b;
  gl_FragColor = vec4(r, c.g, b, c.a);
}
