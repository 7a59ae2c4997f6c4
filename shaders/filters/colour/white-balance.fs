/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Warms or cools the light, and takes green out",
  "CATEGORIES": ["Colour"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"},
    {"NAME": "kelvin", "TYPE": "float", "LABEL": "Kelvin", "DEFAULT": 6504, "MIN": 1800, "MAX": 20000},
    {"NAME": "green", "TYPE": "float", "LABEL": "Green", "DEFAULT": 0, "MIN": -1, "MAX": 1}
  ],
  "SWAPLIGHT": {
    "SPACE": "scene_linear",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 0,
    "SAMPLING": "nearest",
    "UNIT": {"kelvin": "K"},
    "TOOLTIP": {"kelvin": "The light that is to look white: lower makes the picture cooler", "green": "Above 0 takes green out, below 0 adds it"}
  }
}*/
// The white of a colour temperature on the Planckian locus (Kim et al. 2002), in linear Rec.709.
vec3 whiteOf(float kelvin) {
  float t = 1000.0 / kelvin;
  float x = kelvin < 4000.0 ? ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
                            : ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390;
  float y = kelvin < 2222.0   ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
            : kelvin < 4000.0 ? ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867
                              : ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  vec3 xyz = vec3(x / y, 1.0, (1.0 - x - y) / y);
  return xyz * mat3(3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570);
}
void main() {
  vec4 c = IMG_THIS_PIXEL(inputImage);
  vec3 gain = whiteOf(6504.0) / max(whiteOf(kelvin), vec3(0.01));
  gain.g *= exp2(-0.5 * green);
  gain /= dot(gain, vec3(0.2126, 0.7152, 0.0722));  // white keeps its luminance
  gl_FragColor = vec4(c.rgb * gain, c.a);
}
