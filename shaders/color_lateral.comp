// Average over the width of the sample volume, at the scanlines of the frame.
#include "color.glsl"
#include "kernels.glsl"

layout(local_size_x = 64) in;

void main() {
  ivec3 at = ivec3(min(int(gl_GlobalInvocationID.x), color.gates - 1), gl_GlobalInvocationID.yz);
  int center = at.z * color.fineLines + at.y * kColorFine + color.lateralMargin;
  int first = color.axialMargin + 1 + at.x * (color.lateralMargin + 1);
  float sum = 0.0;
  for (int off = -color.lateralMargin; off <= color.lateralMargin; ++off)
    sum += kernel[first + abs(off)] * before[(center + off) * color.gates + at.x];
  after[(at.z * color.lines + at.y) * color.gates + at.x] = sum;
}
