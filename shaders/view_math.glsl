// What a viewer does to a pixel besides the display's own view, as plain functions that GLSL and C++ (through
// GLM) both compile: no in or out parameters, no multi-letter swizzles.

// Scene-linear light that every view can take: NaN becomes 0, infinity the largest half float.
float finiteValue(float value) {
  return isnan(value) ? 0.0 : clamp(value, -65504.0f, 65504.0f);
}

vec3 exposed(vec3 linear, float factor) {
  return vec3(finiteValue(linear.r * factor), finiteValue(linear.g * factor), finiteValue(linear.b * factor));
}

// Stops from middle grey (0.18); what gives no light lies below every band.
float stopsFromGrey(vec3 linear, vec3 luminanceWeights) {
  float luminance = dot(linear, luminanceWeights);
  return luminance > 0.0 ? log2(luminance / 0.18) : -1000.0;
}

// Display code values 0..1.
vec3 withGamma(vec3 code, float gamma) {
  vec3 shown = clamp(code, vec3(0.0), vec3(1.0));
  return gamma == 1.0 ? shown : pow(shown, vec3(1.0 / gamma));
}

// 0: colour; 1, 2, 3: a channel as grey; 4: luma as grey.
vec3 pickedChannel(vec3 code, int channel) {
  if (channel == 1) return vec3(code.r);
  if (channel == 2) return vec3(code.g);
  if (channel == 3) return vec3(code.b);
  if (channel == 4) return vec3(dot(code, vec3(0.2126, 0.7152, 0.0722)));
  return code;
}

// Diagonal stripes, rising over what is too bright and falling over what is too dark. x, y: pixel of the window.
vec3 withZebra(vec3 code, float low, float high, int x, int y) {
  float brightest = max(code.r, max(code.g, code.b));
  if (brightest >= high && ((x + y) & 7) < 4) return vec3(1.0, 0.25, 0.25);
  if (brightest < low && ((x - y) & 7) < 4) return vec3(0.25, 0.4, 1.0);
  return code;
}
