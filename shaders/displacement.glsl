// The way from where tissue is seen to where it lay at rest.

layout(binding = 0) uniform sampler2D displacement;

vec3 shiftAt(vec3 seen_mm) {
  vec2 corner_mm = vec2(frame.displacementLeft_mm, frame.displacementTop_mm);
  ivec2 points = ivec2(frame.displacementColumns, frame.displacementRows);
  vec2 at = clamp((seen_mm.xz - corner_mm) / frame.displacementStep_mm, vec2(0), vec2(points - 1));
  ivec2 low = min(ivec2(at), max(points - 2, 0)), high = min(low + 1, points - 1);
  vec2 f = at - vec2(low);
  vec2 above = mix(texelFetch(displacement, low, 0).xy, texelFetch(displacement, ivec2(high.x, low.y), 0).xy, f.x);
  vec2 below = mix(texelFetch(displacement, ivec2(low.x, high.y), 0).xy, texelFetch(displacement, high, 0).xy, f.x);
  vec2 shift = mix(above, below, f.y);
  return vec3(shift.x, 0, shift.y);
}
