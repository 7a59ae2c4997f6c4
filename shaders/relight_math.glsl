// The arithmetic of relighting, as plain functions that GLSL and C++ (through GLM) both compile: no in or out
// parameters, no multi-letter swizzles. Linear light throughout.

// What a light adds to the picture: its contribution under unit white, times its new colour and strength.
vec3 litBy(vec3 contribution, vec3 factor) {
  return contribution * factor;
}
