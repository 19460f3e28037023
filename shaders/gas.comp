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
  // Threads beyond the frame look at its edge once more.
  int line = min(int(gl_GlobalInvocationID.x), frame.lines - 1);
  int gate = clamp(int(gl_GlobalInvocationID.y), 1, frame.gates - 1);
  GateSample above = samples[gateIndex(frame.planes / 2, gate - 1, line)];
  GateSample here = samples[gateIndex(frame.planes / 2, gate, line)];
  bool enters = (here.marks & kGasHere) != 0 && (above.marks & kGasHere) == 0;
  if (enters && here.level_dB > kBeyond_dB) atomicMin(gasGate[line], gate);
}
