// Average over the length of the sample volume, at the gates of the frame.
#include "color.glsl"
#include "kernels.glsl"

layout(local_size_x = 64) in;

void main() {
  ivec3 at = ivec3(min(int(gl_GlobalInvocationID.x), color.gates - 1), gl_GlobalInvocationID.yz);
  int center = fineIndex(at.z, at.y, at.x * kColorFine + color.axialMargin);
  float sum = kernel[0] * before[center];
  for (int off = 1; off <= color.axialMargin; ++off)
    sum += kernel[off] * (before[center - off] + before[center + off]);
  after[(at.z * color.fineLines + at.y) * color.gates + at.x] = sum;
}
