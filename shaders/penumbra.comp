// Scattering becomes as strong as what reaches it through the aperture: the mean over its rays.
#include "frame.glsl"
#include "records.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 6) readonly buffer Aperture {
  float aperture[];  // [ray][gate][line]
};
layout(std430, binding = 7) readonly buffer Reaching {
  float reaching[];  // [gate][line]
};

const float kNothing_dB = -1e5;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  float seen = 0.0;
  for (int ray = 0; ray < kRays; ++ray) seen += kRayWeight[ray] * aperture[gateIndex(ray, at.y, at.x)];
  float gain_dB = seen < kUnseen ? kNothing_dB : toDecibel(seen / reaching[gateIndex(0, at.y, at.x)]);
  for (int plane = 0; plane < frame.planes; ++plane) samples[gateIndex(plane, at.y, at.x)].echo_dB += gain_dB;
}
