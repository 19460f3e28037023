// Echo of each gate before the beam is applied: scatterers and boundaries of all elevation planes.
#include "frame.glsl"
#include "records.glsl"
#include "hash.glsl"
#include "rest.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 6) readonly buffer Crossings {
  Crossing crossings[];
};
layout(std430, binding = 7) writeonly buffer Echoes {
  float echoes[];
};

// Integral of the quadratic B-spline from the left.
float splineBefore(float x) {
  if (x <= -1.5) return 0.0;
  if (x >= 1.5) return 1.0;
  if (x < -0.5) return (x + 1.5) * (x + 1.5) * (x + 1.5) / 6.0;
  if (x > 0.5) return 1.0 - (1.5 - x) * (1.5 - x) * (1.5 - x) / 6.0;
  return 0.5 + x * (0.75 - x * x / 3.0);
}

// Sum of the boundaries crossed near a gate: Impulse, gathered at its target.
float boundariesAt(int plane, int gate, int line) {
  const int kReach_gates = 8;  // half of the widest box and of the spline
  int first = max(gate - kReach_gates + 1, 0), last = min(gate + kReach_gates, frame.gates - 1);
  float sum = 0.0;
  for (int from = first; from <= last; ++from) {
    Crossing c = crossings[gateIndex(plane, from, line)];
    float off = float(gate - from + 1) - c.fraction, reach = c.width / 2.0;
    // Most gates have none.
    sum += c.echo > 0.0 ? c.echo * (splineBefore(off + reach) - splineBefore(off - reach)) / c.width : 0.0;
  }
  return sum;
}

// Complex amplitudes of three looks at a point of the scatterers' lattice: {re, im} of each.
void scatterersAt(vec3 rest, out float amplitude[6]) {
  vec3 p = carriedBy(frame.latticeFromProbe, rest);
  vec3 whole = floor(p), f = p - whole;
  ivec3 low = frame.latticeBase.xyz + ivec3(whole);
  // The path from the low to the high corner of the cell, longest fraction first.
  bool xy = f.x >= f.y, yz = f.y >= f.z, xz = f.x >= f.z;
  ivec3 rank = ivec3((xy ? 0 : 1) + (xz ? 0 : 1), (xy ? 1 : 0) + (yz ? 0 : 1), (xz ? 1 : 0) + (yz ? 1 : 0));
  float most = max(f.x, max(f.y, f.z)), least = min(f.x, min(f.y, f.z)), middle = f.x + f.y + f.z - most - least;
  vec4 weight = vec4(1.0 - most, most - middle, middle - least, least);
  weight /= length(weight);
  for (int c = 0; c < 6; ++c) amplitude[c] = 0.0;
  for (int corner = 0; corner < 4; ++corner) {
    uint h = hashNode(low + ivec3(lessThan(rank, ivec3(corner))), uint(frame.latticeSeed));
    for (int c = 0; c < 6; ++c) {
      int shift = 5 * c + (c >= 3 ? 1 : 0);
      amplitude[c] += weight[corner] * kScattererUnit * (float(bitfieldExtract(h, shift, 5)) - kScattererMean);
    }
  }
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int line = at.x, gate = at.y;
  float echo[6] = float[6](0.0, 0.0, 0.0, 0.0, 0.0, 0.0), inPhase = 0.0;
  for (int plane = 0; plane < frame.planes; ++plane) {
    GateSample here = samples[gateIndex(plane, gate, line)];
    float amplitude = fromDecibel(here.level_dB + here.echo_dB);
    // Echoes in phase add up to the same level after the beam, whatever its width.
    inPhase += amplitude * (with(kSpeckle) ? here.sheet : 1.0) * frame.plane[plane].z;
    inPhase += boundariesAt(plane, gate, line);
    if (!with(kSpeckle)) continue;
    float loose = amplitude * gateTableAt(gate).y * frame.plane[plane].y;
    float scatterers[6];
    scatterersAt(restPoint(plane, gate, line), scatterers);
    for (int c = 0; c < 6; ++c) echo[c] += loose * scatterers[c];
  }
  for (int look = 0; look < frame.looks; ++look) {
    echoes[gateIndex(2 * look, gate, line)] = echo[2 * look] + inPhase;
    echoes[gateIndex(2 * look + 1, gate, line)] = echo[2 * look + 1];
  }
}
