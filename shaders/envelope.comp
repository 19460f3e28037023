// Magnitude on every sample of one look.
#include "frame.glsl"
#include "kernels.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
uniform int look;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.samples) return;
  int phase = at.y % frame.stride, weights = frame.upsampleTable + 4 * phase;
  int gate = at.y / frame.stride + (2 * phase + 1 < frame.stride ? -1 : 0);
  vec2 sum = vec2(0);
  for (int o = 0; o < 4; ++o) {
    int g = clamp(gate - 1 + o, 0, frame.gates - 1), component = frame.parts * look;
    sum.x += kernel[weights + o] * before[gateIndex(component, g, at.x)];
    if (frame.parts == 2) sum.y += kernel[weights + o] * before[gateIndex(component + 1, g, at.x)];
  }
  after[(look * frame.samples + at.y) * frame.lines + at.x] = length(sum);
}
