/*{
  "ISFVSN": "2",
  "DESCRIPTION": "Takes out single specks and keeps edges: the median of 3 x 3",
  "CATEGORIES": ["Blur"],
  "INPUTS": [
    {"NAME": "inputImage", "TYPE": "image"}
  ],
  "SWAPLIGHT": {
    "SPACE": "any",
    "WHERE": ["shot", "light", "frame"],
    "HALO": 1,
    "SAMPLING": "nearest"
  }
}*/
// The median of nine by exchanges (Smith 1996), a channel at a time.
#define SORT(a, b) { vec3 low = min(a, b); b = max(a, b); a = low; }
void main() {
  vec3 v[9];
  for (int i = 0; i < 9; ++i) v[i] = IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(i % 3 - 1, i / 3 - 1)).rgb;
  SORT(v[1], v[2]) SORT(v[4], v[5]) SORT(v[7], v[8]) SORT(v[0], v[1]) SORT(v[3], v[4]) SORT(v[6], v[7])
  SORT(v[1], v[2]) SORT(v[4], v[5]) SORT(v[7], v[8]) SORT(v[0], v[3]) SORT(v[5], v[8]) SORT(v[4], v[7])
  SORT(v[3], v[6]) SORT(v[1], v[4]) SORT(v[2], v[5]) SORT(v[4], v[7]) SORT(v[4], v[2]) SORT(v[6], v[4])
  SORT(v[4], v[2])
  gl_FragColor = vec4(v[4], IMG_THIS_PIXEL(inputImage).a);
}
