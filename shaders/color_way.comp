// Share of the power that returns from each gate: ReferenceColor::transmissionOf(). A group computes one scanline.
#include "frame.glsl"
#include "field.glsl"
#include "geometry.glsl"
#include "color.glsl"
#include "color_tissue.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 6) writeonly buffer Passed {
  float passed[];  // [line][gate]
};

shared int channelAt[kMostSteps];
shared float powerAt[kMostSteps];

void goDown(int line) {
  float strength = contactAt(planTable[color.lineTable + line].z).y, power = strength * strength;
  int before = -1;
  for (int step = 0; step < color.steps; ++step) {
    int here = channelAt[step];
    // In front of the skin there is gel, which does not weaken the echoes.
    if (here != frame.backgroundChannel) {
      int pair = (before < 0 ? here : before) * 16 + here;
      power *= color.transmitted[pair >> 2][pair & 3];
      before = here;
    }
    powerAt[step] = power;
  }
}

void main() {
  int line = int(gl_WorkGroupID.x), thread = int(gl_LocalInvocationID.x);
  float distance_mm[16];
  // The last threads take the first steps, and a thread in the middle goes down, so that either missing barrier shows
  // where threads run in their order.
  for (int step = 63 - thread; step < color.steps; step += 64) {
    vec2 rest = restBetween(line, color.gateKnots, step);
    channelAt[step] = lookUp(vec3(rest.x, 0, rest.y), distance_mm);
  }
  barrier();
  if (thread == 32) goDown(line);
  barrier();
  for (int gate = thread; gate < color.fineGates; gate += 64) {
    float range_mm = color.firstRange_mm + float(gate) * color.fineGate_mm;
    float step = max(range_mm / kTransmissionStep_mm - 0.5, 0.0);
    int low = int(step);
    passed[line * color.fineGates + gate] = mix(powerAt[low], powerAt[low + 1], step - float(low));
  }
}
