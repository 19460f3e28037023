// Contact of each column of the lattice with the skin: TissueLookup's contactOf().
#include "frame.glsl"
#include "field.glsl"
#include "geometry.glsl"
#include "displacement.glsl"

layout(local_size_x = 32) in;
layout(std430, binding = 3) writeonly buffer Contacts {
  vec2 contacts[];
};

// Distance from the outside: negative outside, positive in the body.
float depthAt(int line, float range_mm) {
  vec3 seen = pointOn(line, range_mm);
  FieldCell cell = fieldCellAt(carriedBy(frame.nodeFromProbe, seen + shiftAt(seen)));
  float depth = 0.0;
  for (int corner = 0; corner < 8; ++corner)
    depth += cornerWeight(cell, corner) * distanceAt(cornerOffset(cell, corner), frame.backgroundChannel);
  return depth;
}

vec2 contactAt(int line) {
  if (frame.backgroundChannel < 0) return vec2(0, 1);
  const float kStep_mm = 0.5;
  float atFace = depthAt(line, 0.0);
  float outward = atFace < 0.0 ? 1.0 : -1.0;
  float previous = atFace;
  for (float r = kStep_mm; r <= kContactReach_mm; r += kStep_mm) {
    float here = depthAt(line, outward * r);
    if ((here < 0.0) != (atFace < 0.0)) {
      float gap = outward * (r - kStep_mm * here / (here - previous));
      float lost = clamp((gap - kPoorContact_mm) / (kContactReach_mm - kPoorContact_mm), 0.0, 1.0);
      float into = clamp((-gap / kContactReach_mm - 2.0 / 3.0) * 3.0, 0.0, 1.0);
      return vec2(gap * (1.0 - into * into * (3.0 - 2.0 * into)), 1.0 - lost * lost * (3.0 - 2.0 * lost));
    }
    previous = here;
  }
  return vec2(0, atFace < 0.0 ? 0.0 : 1.0);
}

void main() {
  int column = min(int(gl_GlobalInvocationID.x), frame.nodeColumns - 1);
  vec2 contact = contactAt(column * frame.cellLines);
  if (frame.conforming == 0) contact.x = 0.0;
  contacts[column] = contact;
}
