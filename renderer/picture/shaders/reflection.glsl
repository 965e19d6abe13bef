#include "frame.glsl"

// Reflection of the environment by a rough surface (microfacets after Walter et al. 2007). The lamps are boxes in the
// environment, so there is no separate highlight of a point light.

// Schlick's Fresnel term (1994).
float fresnel_weight(float cosine) {
  float m = 1.0 - saturate(cosine);
  return square(square(m)) * m;
}

// Part of an even environment that a rough surface reflects, as scale and bias of its reflectance at normal incidence;
// Karis's fit (2014) to the integral of the microfacet model.
vec2 reflected_part(float nv, float roughness) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a + r.zw;
}
