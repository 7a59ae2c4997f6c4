#version 410 core
// Shows a part of a linear picture in a window. Row 0 of picture and window is the top one.
#include "view_math.glsl"

const int kMaxBands = 16;
uniform sampler2D picture;  // one tile of it
uniform ivec2 tileOrigin;   // the tile's first pixel in the whole picture
uniform ivec2 tileSize;
uniform vec2 windowOrigin;  // the whole picture's point at the window's left top corner
uniform float zoom;         // window pixels a picture pixel
uniform int level;          // of the halved pictures; with `smoothed`
uniform int smoothed;       // 1: interpolated, 0: pixels as squares
uniform vec3 side;          // drawn where dot(side, (x, y, 1)) >= 0
uniform int absolute;       // 1: the picture is a difference, of which the size is shown

uniform float exposureFactor;
uniform float gamma;
uniform int channel;
uniform int zebra;
uniform float zebraLow;
uniform float zebraHigh;
uniform int falseColor;
uniform int bandCount;
uniform float bandStops[kMaxBands];
uniform vec3 bandColors[kMaxBands];
uniform vec3 luminanceWeights;

out vec4 color;

#pragma injected

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  if (dot(side, vec3(gl_FragCoord.xy, 1.0)) < 0.0) discard;
  vec2 point = windowOrigin + gl_FragCoord.xy / zoom - vec2(tileOrigin);
  if (any(lessThan(point, vec2(0.0))) || any(greaterThanEqual(point, vec2(tileSize)))) discard;
  vec3 linear = smoothed == 1 ? textureLod(picture, point / vec2(tileSize), float(level)).rgb
                              : texelFetch(picture, ivec2(point), 0).rgb;
  if (absolute == 1) linear = abs(linear);
  linear = exposed(linear, exposureFactor);
  if (falseColor == 1) {
    float stops = stopsFromGrey(linear, luminanceWeights);
    vec3 shown = bandColors[0];
    for (int i = 1; i < bandCount; ++i)
      if (stops >= bandStops[i]) shown = bandColors[i];
    color = vec4(shown, 1.0);
    return;
  }
  vec3 code = pickedChannel(withGamma(displayFromScene(vec4(linear, 1.0)).rgb, gamma), channel);
  if (zebra == 1) code = withZebra(code, zebraLow, zebraHigh, pixel.x, pixel.y);
  color = vec4(code, 1.0);
}
