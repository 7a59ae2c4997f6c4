#version 410 core
// Sums the lights of a pass. A layer of `contributions` is one light under unit white (or the ambient light).
#include "relight_math.glsl"

const int kMaxLights = 64;
uniform sampler2DArray contributions;
uniform int lightCount;
uniform int layers[kMaxLights];
uniform vec3 factors[kMaxLights];

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < lightCount; ++i)
    sum += litBy(texelFetch(contributions, ivec3(pixel, layers[i]), 0).rgb, factors[i]);
  color = vec4(sum, 1.0);
}
