/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Brown tones of an old print",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "amount", "TYPE": "float", "LABEL": "Amount", "DEFAULT": 1, "MIN": 0, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "display",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 toned = vec3(dot(c.rgb, vec3(0.393, 0.769, 0.189)), dot(c.rgb, vec3(0.349, 0.686, 0.168)),
                    dot(c.rgb, vec3(0.272, 0.534, 0.131)));
  gl_FragColor = vec4(mix(c.rgb, toned, amount), c.a);
}
