// The width of the beam. Beyond the sides there is nothing, or what is at the sides.
#include "frame.glsl"
#include "geometry.glsl"
#include "kernels.glsl"

layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int radius = int(gateTableAt(at.y).z), first = frame.lateralKernel + at.y * frame.lateralEntries;
  float sum = 0.0;
  for (int off = -radius; off <= radius; ++off) {
    int line = clamp(at.x + off, 0, frame.lines - 1);
    if (line == at.x + off || frame.clampSides != 0)
      sum += kernel[first + abs(off)] * before[gateIndex(at.z, at.y, line)];
  }
  after[gateIndex(at.z, at.y, at.x)] = sum;
}
