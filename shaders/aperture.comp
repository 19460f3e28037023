// Transmission to each gate along each ray of the aperture: ApertureRays. A group follows one ray down the image, a
// thread takes a scanline.
#include "frame.glsl"
#include "geometry.glsl"

layout(local_size_x = 1024) in;
layout(std430, binding = 5) readonly buffer Reaching {
  float reaching[];  // [gate][line]
};
layout(std430, binding = 7) writeonly buffer Aperture {
  float aperture[];  // [ray][gate][line]
};

const int kAhead = 8;  // gates that are read together, so that a gate does not wait for memory

shared float left[2][1024];  // by parity of the gate, of each scanline behind it

void main() {
  int ray = int(gl_WorkGroupID.x), line = int(gl_LocalInvocationID.x), own = min(line, frame.lines - 1);
  float ahead[kAhead + 1], shift[kAhead];
  for (int first = 0; first < frame.gates; first += kAhead) {
    for (int n = 0; n <= kAhead; ++n) ahead[n] = reaching[gateIndex(0, min(first + n, frame.gates), own)];
    for (int n = 0; n < kAhead; ++n) shift[n] = kRayTangent[ray] * gateTableAt(first + n).w;
    for (int n = 0; n < kAhead; ++n) {
      int gate = first + n, above = (n + 1) & 1;
      int beside = clamp(line + (shift[n] > 0.0 ? 1 : -1), 0, frame.lines - 1);
      float here = gate == 0 ? ahead[0] : mix(left[above][own], left[above][beside], abs(shift[n]));
      if (line < frame.lines && gate < frame.gates) aperture[gateIndex(ray, gate, line)] = here;
      left[n & 1][line] = here * ahead[n + 1] / ahead[n];
      barrier();
    }
  }
}
