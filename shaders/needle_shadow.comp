// Takes from the beam what a needle keeps from it.
#include "frame.glsl"
#include "records.glsl"
#include "needle.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 7) buffer Crossings {
  Crossing crossings[];
};

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int n = gateIndex(at.z, at.y, at.x);
  float shadow_dB = shadowAt(at.z, at.y, at.x);
  samples[n].level_dB -= shadow_dB;
  crossings[n].echo *= fromDecibel(-shadow_dB);
}
