#version 410 core
// Adds up pictures, each times a factor: the lights of a set, and what no light explains. How many is a
// constant, kPictures, so that every sampler is known to the compiler; the factors are uniforms.
#include "relight_math.glsl"

#pragma injected
uniform sampler2D pictures[kPictures];
uniform vec3 factors[kPictures];

out vec4 color;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < kPictures; ++i) sum += litBy(texelFetch(pictures[i], pixel, 0).rgb, factors[i]);
  color = vec4(sum, 1.0);
}
