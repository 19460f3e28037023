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

// Rings and layers of the mirrored tissue come and go along the surface, each in its own way; those of a lung slide.
float strengthOf(ivec3 step, vec3 surface, float slide_voxels, int finer) {
  vec3 at = carriedBy(frame.patchFromProbe, surface) - vec3(0, 0, slide_voxels);
  float patches = tileAt(kPatchTile, finer * frame.patchBase.xyz + ivec3(floor(float(finer) * at)) + step) / 32.0;
  return clamp(1.0 + 1.2 * patches, 0.0, 2.5);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int gas = gasGate[at.x], behind = at.y - gas;
  if (behind < kFirstGateBehind) return;
  vec3 surface = restPoint(frame.planes / 2, gas, at.x);
  vec4 repeat = repeats[behind];
  int ring = int(repeat.z), ringAbove = int(repeat.w);
  float beside_mm = dot(frame.fromMiddle[1], vec4(surface, 1));
  bool lung = abs(beside_mm) > kLungFromTrachea_mm;
  float detached_mm = beside_mm > 0.0 ? frame.lungDetached_mm.y : frame.lungDetached_mm.x;
  float slide = lung && abs(beside_mm) >= detached_mm ? frame.lungSlide_voxels : 0.0;
  int perLayer = max(1, int(floor(kPatchVoxel_mm / frame.gate_mm + 0.5)));
  int layer = lung ? behind / perLayer : 0;
  float gain = lung ? kLungGain * exp(float(layer * perLayer) * frame.gate_mm * kLungGrowth_perMm) : 1.0;
  int finer = lung ? kLungFiner : 1;
  float grain = gain * strengthOf(layer * ivec3(23, 11, 37), surface, slide, finer);
  float mirror = behind <= gas ? repeat.x * grain : 0.0;
  float rings = ringAbove <= gas ? repeat.y * strengthOf(ring * ivec3(17, 29, 41), surface, slide, 1) : 0.0;
  for (int c = 0; c < 2 * frame.looks; ++c) {
    float above = rings * echoes[gateIndex(c, max(gas - ringAbove, 0), at.x)];
    above += mirror * echoes[gateIndex(c, max(gas - behind, 0), at.x)];
    echoes[gateIndex(c, at.y, at.x)] += above;
  }
}
