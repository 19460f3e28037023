// The first gate of each scanline in gas behind tissue, in the central plane; -1 if none. A group a scanline.
#include "frame.glsl"
#include "records.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 6) writeonly buffer GasGates {
  int gasGate[];
};

shared int firstTissue, firstGas, firstLost;

void main() {
  int line = int(gl_WorkGroupID.x), thread = int(gl_LocalInvocationID.x), central = frame.planes / 2;
  if (thread == 0) firstTissue = frame.gates, firstGas = frame.gates, firstLost = frame.gates;
  barrier();
  for (int gate = thread; gate < frame.gates; gate += 64) {
    int marks = samples[gateIndex(central, gate, line)].marks;
    if ((marks & kGasHere) == 0) atomicMin(firstTissue, gate);
    if ((marks & kInside) == 0) atomicMin(firstLost, gate);
  }
  barrier();
  for (int gate = thread; gate < frame.gates; gate += 64)
    if (gate > firstTissue && (samples[gateIndex(central, gate, line)].marks & kGasHere) != 0)
      atomicMin(firstGas, gate);
  barrier();
  if (thread == 0) gasGate[line] = firstGas < firstLost ? firstGas : -1;
}
