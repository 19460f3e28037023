// Amplitude, there and back, that reaches a gate, as its own scanline lets it pass: the mean over the planes.
#include "frame.glsl"
#include "records.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 7) writeonly buffer Reaching {
  float reaching[];  // [gate][line], and what leaves the last gate
};

// Rays begin with the value of gate 0 and divide by it again: only later gates matter.
float reachingAt(int gate, int line) {
  float sum = 0.0;
  for (int plane = 0; plane < frame.planes; ++plane) {
    GateSample above = samples[gateIndex(plane, max(gate - 1, 0), line)];
    sum += frame.plane[plane].z * fromDecibel(above.level_dB - above.loss_dB / 2.0);
  }
  return max(sum, kFaintest);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x < frame.lines && at.y <= frame.gates) reaching[gateIndex(0, at.y, at.x)] = reachingAt(at.y, at.x);
}
