// The first gate of each scanline in gas behind tissue, in the central plane.
#include "frame.glsl"
#include "records.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 6) buffer GasGates {
  int gasGate[];  // beyond the last where there is none; levels.comp has begun it so
};

const float kBeyond_dB = -9e3;  // what is left of a beam that has been beyond the volume is less

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates || at.y == 0) return;
  GateSample above = samples[gateIndex(frame.planes / 2, at.y - 1, at.x)];
  GateSample here = samples[gateIndex(frame.planes / 2, at.y, at.x)];
  bool enters = (here.marks & kGasHere) != 0 && (above.marks & kGasHere) == 0;
  if (enters && here.level_dB > kBeyond_dB) atomicMin(gasGate[at.x], at.y);
}
