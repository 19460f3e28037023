// Transmission to each gate along each ray of the aperture: ApertureRays. A group follows one ray down the image, its
// threads take the scanlines.
#include "frame.glsl"
#include "records.glsl"
#include "rest.glsl"

layout(local_size_x = 128) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 7) writeonly buffer Aperture {
  float aperture[];  // [ray][gate][line]
};
#include "reaching.glsl"

shared float left[2][1024];  // by parity of the gate, of each scanline behind it

void main() {
  int ray = int(gl_WorkGroupID.x);
  for (int gate = 0; gate < frame.gates; ++gate) {
    float shift = kRayTangent[ray] * gateTableAt(gate).w;
    for (int line = int(gl_LocalInvocationID.x); line < frame.lines; line += 128) {
      int beside = clamp(line + (shift > 0.0 ? 1 : -1), 0, frame.lines - 1), above = (gate + 1) & 1;
      float reaching = reachingAt(gate, line);
      float here = gate == 0 ? reaching : mix(left[above][line], left[above][beside], abs(shift));
      aperture[gateIndex(ray, gate, line)] = here;
      left[gate & 1][line] = here * reachingAt(gate + 1, line) / reaching;
    }
    barrier();
  }
}
