// Remaining level of the beam at each gate, there and back: losses summed down the scanline. A group takes 16
// scanlines, 16 threads a scanline: each sums its part of the gates, then goes over it again from where the parts
// before have led.
#include "frame.glsl"
#include "records.glsl"
#include "rest.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 5) buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 6) buffer Crossings {
  Crossing crossings[];
};
layout(std430, binding = 7) writeonly buffer GasGates {
  int gasGate[];
};

const float kNoContact = 1e-9, kUnseen_dB = -150.0, kFaintest_dB = -300.0, kUnknown_dB = -5e3;

shared float total_dB[16][16];  // [part][scanline]

void main() {
  int line = min(int(gl_GlobalInvocationID.x), frame.lines - 1), plane = int(gl_WorkGroupID.z);
  // The last threads take the first gates, so that a missing barrier shows where threads run in their order.
  int part = 15 - int(gl_LocalInvocationID.y), column = int(gl_LocalInvocationID.x);
  int length_ = (frame.gates + 15) / 16;
  int first = part * length_, end = min(first + length_, frame.gates);

  float sum_dB = 0.0;
  for (int gate = first; gate < end; ++gate) {
    int n = gateIndex(plane, gate, line);
    sum_dB += samples[n].loss_dB + crossings[n].loss_dB;
  }
  total_dB[part][column] = sum_dB;
  barrier();
  if (int(gl_GlobalInvocationID.x) >= frame.lines) return;

  gasGate[line] = frame.gates;  // none yet, for gas.comp
  float level_dB = toDecibel(max(contactOf(line).y, kNoContact));
  for (int before = 0; before < part; ++before) level_dB -= total_dB[before][column];
  for (int gate = first; gate < end; ++gate) {
    int n = gateIndex(plane, gate, line);
    crossings[n].echo *= level_dB > kUnseen_dB ? fromDecibel(level_dB) : 0.0;
    level_dB -= crossings[n].loss_dB;
    float left_dB = level_dB > kUnknown_dB ? max(level_dB, kFaintest_dB) : level_dB;
    samples[n].level_dB = left_dB - samples[n].loss_dB / 2.0;
    level_dB -= samples[n].loss_dB;
  }
}
