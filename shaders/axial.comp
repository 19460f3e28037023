// The pulse.
#include "frame.glsl"
#include "kernels.glsl"

layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int radius = frame.axialEntries - 1, center = at.y * frame.axialEntries;
  int first = max(at.y - radius, 0), last = min(at.y + radius, frame.gates - 1);
  float sum = 0.0;
  for (int gate = first; gate <= last; ++gate) sum += kernel[center + abs(gate - at.y)] * before[gateIndex(at.z, gate, at.x)];
  after[gateIndex(at.z, at.y, at.x)] = sum;
}
