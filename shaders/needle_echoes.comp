// Adds a needle's echoes: its near side, and what comes again from between its walls.
#include "frame.glsl"
#include "records.glsl"
#include "needle.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];  // in the needle's shadow
};
layout(std430, binding = 7) buffer Echoes {
  float echoes[];
};

float amplitudeAt(int gate, int line) {
  int first = int(words[4 * line]), end = int(words[4 * line + 1]);
  return gate >= first && gate < end ? words[int(words[4 * line + 3]) + gate - first] : 0.0;
}

float echoAt(float gate, int line) {
  int below = int(floor(gate));
  return mix(amplitudeAt(below, line), amplitudeAt(below + 1, line), gate - float(below));
}

// Level of a beam that the needle has not met.
float levelAt(int gate, int line) {
  int plane = frame.planes / 2;
  return samples[gateIndex(plane, gate, line)].level_dB + shadowAt(plane, gate, line);
}

float levelBetween(float gate, int line) {
  int below = int(gate);
  return mix(levelAt(below, line), levelAt(min(below + 1, frame.gates - 1), line), gate - float(below));
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  float ring_gates = words[4 * at.x + 2], sum = 0.0, share = 1.0;
  for (int ring = 0; ring <= (ring_gates > 0.0 ? kNeedleRings : 0); ++ring) {
    float from = float(at.y) - float(ring) * ring_gates, echo = echoAt(from, at.x);
    if (echo > 0.0) sum += share * echo * fromDecibel(levelBetween(max(from, 0.0), at.x));
    share *= ring == 0 ? kFirstNeedleRing : kNextNeedleRing;
  }
  for (int look = 0; look < frame.looks; ++look) echoes[gateIndex(2 * look, at.y, at.x)] += sum;
}
