#include "frame.glsl"

// Reflection of the environment by a rough surface (microfacets after Walter et al. 2007). The lamps are boxes in the
// environment, so there is no separate highlight of a point light, but for that of an endoscope's lamp.

// Schlick's Fresnel term (1994).
float fresnel_weight(float cosine) {
  float m = 1.0 - saturate(cosine);
  return square(square(m)) * m;
}

// How much longer the way of light through a layer of water is than the layer is deep, which it enters at this cosine: it is
// bent towards the normal (Snell).
float slant(float cosine) {
  const float kWater = 1.33;
  return inversesqrt(1.0 - (1.0 - square(cosine)) / square(kWater));
}

// Part of an even environment that a rough surface reflects, as scale and bias of its reflectance at normal incidence;
// Karis's fit (2014) to the integral of the microfacet model.
vec2 reflected_part(float nv, float roughness) {
  vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
  float a = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
  return vec2(-1.04, 1.04) * a + r.zw;
}

// What microfacets of GGX with width `alpha` reflect of a small lamp, for a mirror, over what a white matte surface that
// faces the lamp would send back; masking and shadowing after Smith.
float glint(vec3 normal, vec3 view, vec3 toward, float alpha) {
  vec3 halfway = normalize(view + toward);
  float squared = square(alpha);
  float nl = saturate(dot(normal, toward));
  float nv = max(dot(normal, view), 0.02);
  float nh = saturate(dot(normal, halfway));
  float spread = square(nh) * (squared - 1.0) + 1.0;
  float masked = nl * sqrt(square(nv) * (1.0 - squared) + squared) + nv * sqrt(square(nl) * (1.0 - squared) + squared);
  // kPi cancels between the distribution of normals and the matte surface.
  return 0.5 * nl * squared / (square(spread) * max(masked, 1e-4));
}
