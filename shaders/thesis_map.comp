// Medium and boundaries on the map rows, in the look of the thesis: mapAt() of ThesisModel.cpp.
#include "frame.glsl"
#include "thesis.glsl"
#include "records.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Nodes {
  Node nodes[];
};
layout(std430, binding = 6) writeonly buffer Map {
  vec4 map[];  // reflection, loss in dB/mm, echo
};

struct Medium {
  float lnImpedanceSlope, loss_dBpmm, echo_dB;
};

// Indices of nodes whose mean is the value at a map row, and whose difference is the slope.
struct MapPlace {
  int here, next, above, below;
  float perMm;
};

float valueOf(MapPlace p, int c) {
  return 0.5 * (nodes[p.here].distance_mm[c] + nodes[p.next].distance_mm[c]);
}

float slopeOf(MapPlace p, int c) {
  return p.perMm * (nodes[p.below].distance_mm[c] - nodes[p.above].distance_mm[c]);
}

// Beyond the lattice, 0 within .. 1.
float beyondOf(int node) {
  return min(1.0, 2.0 * nodes[node].beyond);
}

Medium mediumAt(MapPlace p, int without) {
  float first = 1e3, second = 1e3, firstSlope = 0.0, secondSlope = 0.0;
  for (int c = 0; c < frame.channels; ++c) {
    if (c == without) continue;
    float d = valueOf(p, c);
    if (d < first) {
      second = first, secondSlope = firstSlope;
      first = d, firstSlope = slopeOf(p, c);
    } else if (d < second) {
      second = d, secondSlope = slopeOf(p, c);
    }
  }
  float middle = (first + second) / 2.0, middleSlope = (firstSlope + secondSlope) / 2.0;
  vec4 sum = vec4(0), slope = vec4(0);  // ln Z, its change per HU, -, weights
  float loss = 0.0, echo = 0.0, echoPerHU = 0.0;
  for (int c = 0; c < frame.channels; ++c) {
    if (c == without) continue;
    float t = clamp(0.5 - (valueOf(p, c) - middle) / thesis.interface_mm, 0.0, 1.0);
    float w = fade(t), ws = -fadeSlope(t) * (slopeOf(p, c) - middleSlope) / thesis.interface_mm;
    vec4 m = thesis.medium[c];
    sum += w * vec4(m.xy, 0, 1), slope += ws * vec4(m.xy, 0, 1);
    loss += w * m.z, echo += w * m.w, echoPerHU += w * thesis.perHU[c].x;
  }
  vec2 value = sum.xy / sum.w, change = (slope.xy - value * slope.w) / sum.w;
  float ct = 0.5 * (nodes[p.here].ct_HU + nodes[p.next].ct_HU);
  float ctSlope = p.perMm * (nodes[p.below].ct_HU - nodes[p.above].ct_HU);
  return Medium(change.x + change.y * ct + value.y * ctSlope, loss / sum.w, (echo + echoPerHU * ct) / sum.w);
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.nodeColumns || at.y >= thesis.mapRows) return;
  // On a row of nodes the slope is that of the rows before and after, midway between two it is theirs.
  bool onNodes = at.y % 2 == 0;
  int row = at.y / 2, next = onNodes ? row : row + 1;
  int above = onNodes ? max(row - 1, 0) : row, below = onNodes ? min(row + 1, frame.nodeRows - 1) : next;
  MapPlace p = MapPlace(nodeIndex(at.z, row, at.x), nodeIndex(at.z, next, at.x), nodeIndex(at.z, above, at.x),
                        nodeIndex(at.z, below, at.x), 1.0 / (float(below - above) * thesis.row_mm));

  // Gel matches the tissue behind it and neither scatters nor absorbs.
  float range_mm = rangeOf(0.0) + float(at.y) * thesis.row_mm / 2.0;
  int gel = range_mm < kContactReach_mm ? frame.backgroundChannel : -1;
  float tissue = gel < 0 ? 1.0 : fade(clamp(0.5 + valueOf(p, gel) / thesis.interface_mm, 0.0, 1.0));
  Medium m = mediumAt(p, frame.channels > 1 ? gel : -1);
  float beyond = 0.5 * (beyondOf(p.here) + beyondOf(p.next));
  float seen = (1.0 - beyond) * tissue;
  float artanh = thesis.steepness_mm * abs(m.lnImpedanceSlope) / 2.0;

  float reflection = with(kReflection) ? seen * fromDecibel(kThesisReflectorGain_dB) * tanh(min(artanh, 20.0)) : 0.0;
  float loss = tissue * m.loss_dBpmm + kBeyondLoss_dBpmm * beyond;
  if (with(kTransmission)) {
    // 1 - R^2 = 1 / cosh^2(artanh R).
    float lnCosh = artanh + log(1.0 + exp(-2.0 * artanh)) - 0.6931471806;
    loss += tissue * 17.3717792761 * lnCosh / thesis.lossLength_mm;
  }
  float echo = with(kScattering) ? seen * fromDecibel(m.echo_dB) : 0.0;
  map[(at.z * thesis.mapRows + at.y) * frame.nodeColumns + at.x] = vec4(reflection, loss, echo, 0);
}
