// Boundaries that scanlines cross between two gates: LineTracer::boundary(), but for what is left of the beam.
#include "frame.glsl"
#include "records.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Cells {
  Cell cells[];
};
layout(std430, binding = 6) readonly buffer Samples {
  GateSample samples[];
};
layout(std430, binding = 7) writeonly buffer Crossings {
  Crossing crossings[];
};

// roughnessGain_dB() of model/Boundary.h.
float roughnessGain(float roughness_dB, float comesAndGoes) {
  return roughness_dB * (comesAndGoes * (comesAndGoes < 0.0 ? kRoughnessBreaks : 1.0) - kRoughnessLoss);
}

float specularLobe(int above, int below, float cosine) {
  float n = (frame.channel[above].specularExponent + frame.channel[below].specularExponent) / 2.0;
  float diffuse = (frame.channel[above].specularDiffuse + frame.channel[below].specularDiffuse) / 2.0;
  return (1.0 - diffuse) * pow(cosine, n) + diffuse * cosine;
}

Crossing crossingAt(int plane, int gate, int line) {
  Crossing none = Crossing(0.0, 0.0, 1.0, 0.0);
  if (gate == 0) return none;
  GateSample above = samples[gateIndex(plane, gate - 1, line)], below = samples[gateIndex(plane, gate, line)];
  if (above.channel == below.channel || (above.marks & kOutside) != 0 || (below.marks & kInside) == 0) return none;
  Cell cellAbove = cells[cellIndex(plane, gate - 1, line)], cell = cells[cellIndex(plane, gate, line)];

  float reflection =
      (below.impedance_MRayl - above.impedance_MRayl) / (below.impedance_MRayl + above.impedance_MRayl);
  // surfaceOf() of model/Boundary.h.
  bool vesselAbove = (frame.channel[above.channel].flags & kVessel) != 0;
  float roughness_dB = frame.channel[vesselAbove ? above.channel : below.channel].roughness_dB;
  Crossing crossing = none;
  if (with(kReflection)) {
    float rough_dB =
        with(kTexture) ? roughnessGain(roughness_dB, withinCell(cell.comesAndGoes, gate, line)) : 0.0;
    crossing.echo = abs(reflection) * fromDecibel(kReflectorGain_dB + rough_dB) *
                    specularLobe(above.channel, below.channel, cell.cosine) * frame.boundaryScale *
                    frame.plane[plane].z;
  }
  bool samePair = cellAbove.a == cell.a && cellAbove.b == cell.b;
  crossing.fraction = samePair ? above.s_mm / (above.s_mm - below.s_mm) : 0.5;
  float roughDepth_mm = with(kTexture) ? kRoughnessDepth_mmPdB * roughness_dB : 0.0;
  crossing.width = clamp(length(vec2(cell.spread_mm, roughDepth_mm)) / frame.gate_mm, kNarrowest_gates, kWidest_gates);
  if (with(kTransmission)) crossing.loss_dB = -toDecibel(max(1.0 - reflection * reflection, 1e-12));
  return crossing;
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  crossings[gateIndex(at.z, at.y, at.x)] = crossingAt(at.z, at.y, at.x);
}
