// The radial blur's exponential tail: each gate passes a share on to the next.
#include "frame.glsl"
#include "thesis.glsl"
#include "kernels.glsl"

layout(local_size_x = 32, local_size_y = 2) in;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  const float kNothing = 1e-7;
  float passed = 1.0, sum = 0.0;
  int gate = at.y;
  for (; gate > 0 && passed > kNothing; --gate, passed *= thesis.tailShare)
    sum += passed * (1.0 - thesis.tailShare) * before[gateIndex(0, gate, at.x)];
  if (gate == 0) sum += passed * before[gateIndex(0, 0, at.x)];
  after[gateIndex(0, at.y, at.x)] = sum;
}
