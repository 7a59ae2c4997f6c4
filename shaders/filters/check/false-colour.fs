/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Exposure as colours: a band a stop from middle grey",
  "CATEGORIES": ["Check"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "HALO": 0,
    "SAMPLING": "nearest"
  }
}*/
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  float y = dot(c.rgb, vec3(0.2126, 0.7152, 0.0722));
  float stops = log2(max(y, 1e-6) / 0.18);
  vec3 v = stops < -5.0   ? vec3(0.0)
           : stops < -4.0 ? vec3(0.16, 0.02, 0.32)
           : stops < -3.0 ? vec3(0.05, 0.06, 0.6)
           : stops < -2.0 ? vec3(0.02, 0.3, 0.75)
           : stops < -1.0 ? vec3(0.05, 0.5, 0.45)
           : stops < -0.5 ? vec3(0.1, 0.42, 0.1)
           : stops < 0.5  ? vec3(0.21)
           : stops < 1.0  ? vec3(0.72, 0.42, 0.42)
           : stops < 2.0  ? vec3(0.85, 0.7, 0.08)
           : stops < 3.0  ? vec3(0.9, 0.36, 0.02)
           : stops < 4.0  ? vec3(0.8, 0.04, 0.03)
                          : vec3(1.0);
  gl_FragColor = vec4(v, c.a);
}
