// Behind gas: the tissue above, mirrored, and rings between gas and probe.
#include "frame.glsl"
#include "tiles.glsl"
#include "rest.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer GasGates {
  int gasGate[];
};
layout(std430, binding = 6) readonly buffer Repeats {
  vec4 repeats[];  // by gates behind: shares of the mirror and of the ring, number of the ring, gates above for it
};
layout(std430, binding = 7) buffer Echoes {
  float echoes[];
};

// Rings come and go along the surface, each in its own way.
float strengthOf(int ring, vec3 surface) {
  return clamp(1.0 + 1.2 * comesAndGoesAt(surface, ring * ivec3(17, 29, 41)), 0.0, 2.5);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int gas = gasGate[at.x], behind = at.y - gas;
  if (behind < kFirstGateBehind) return;
  vec3 surface = restPoint(frame.planes / 2, gas, at.x);
  vec4 repeat = repeats[behind];
  int ring = int(repeat.z), ringAbove = int(repeat.w);
  float mirror = behind <= gas ? repeat.x * strengthOf(0, surface) : 0.0;
  float rings = ringAbove <= gas ? repeat.y * strengthOf(ring, surface) : 0.0;
  for (int c = 0; c < 2 * frame.looks; ++c) {
    float above = rings * echoes[gateIndex(c, max(gas - ringAbove, 0), at.x)];
    above += mirror * echoes[gateIndex(c, max(gas - behind, 0), at.x)];
    echoes[gateIndex(c, at.y, at.x)] += above;
  }
}
