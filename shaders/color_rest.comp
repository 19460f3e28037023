// Positions at rest of the tissue at every fourth point of a scanline of color (knots), first of its gates, then of the
// steps of transmission: ShownTissue::restOf(). Points between knots are interpolated.
#include "frame.glsl"
#include "geometry.glsl"
#include "displacement.glsl"
#include "color.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 5) writeonly buffer Rests {
  vec2 rests[];  // x and z, [line][knot]
};

void main() {
  int n = min(int(gl_GlobalInvocationID.x), restIndex(color.fineLines, 0) - 1);
  vec4 shown = planTable[color.knotTable + 2 * n], at = planTable[color.knotTable + 2 * n + 1];
  vec3 drawn = vec3(shown.x, 0, shown.y) +
               vec3(shown.z, 0, shown.w) * (tissueRange(at.x, contactAt(at.y).x) - at.x);
  rests[n] = (drawn + shiftAt(drawn)).xz;
}
