// The two nearest structures of each cell of the lattice, and the boundary between them: TissueLookup::cellOf().
#include "frame.glsl"
#include "records.glsl"
#include "geometry.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 4) readonly buffer Shifts {
  vec2 shifts[];
};
layout(std430, binding = 5) readonly buffer Nodes {
  Node nodes[];
};
layout(std430, binding = 6) writeonly buffer Cells {
  Cell cells[];
};

const float kSteepest = 0.3;  // gradients of smoothed distances below this are ridges between structures
const float kLeastSlope = 1e-3;
const float kLeastVolume = 0.01;

// Slope in the plane of a distance at rest, from its slopes in displaced tissue.
float inPlaneSlopeAtRest(int row, int column, float axial, float lateral, float range_mm) {
  int top = nodeIndex(0, row, column), bottom = nodeIndex(0, row + 1, column);
  vec2 a = shifts[top], b = shifts[top + 1], c = shifts[bottom], d = shifts[bottom + 1];
  vec2 byAxial = (c - a + d - b) / (2.0 * float(frame.cellGates) * frame.gate_mm);
  vec2 byLateral = (b - a + d - c) / (2.0 * float(frame.cellLines) * scanlineSpacing(range_mm));
  vec2 beam = planTable[column * frame.cellLines].zw, side = vec2(beam.y, -beam.x);
  float aa = 1.0 + dot(beam, byAxial), la = dot(side, byAxial), al = dot(beam, byLateral),
        ll = 1.0 + dot(side, byLateral);
  return length(vec2(ll * axial - la * lateral, aa * lateral - al * axial)) / max(aa * ll - la * al, kLeastVolume);
}

float boundaryAt(int plane, int row, int column, int a, int b) {
  int n = nodeIndex(plane, row, column);
  return (nodes[n].distance_mm[b] - nodes[n].distance_mm[a]) / 2.0;
}

// Across the slice, from the neighboring planes. A single plane has none: there the gradient at rest is taken to be 1.
float elevationSlope(ivec3 at, int a, int b, float axial, float lateral, float range_mm, float sd_mm) {
  int last = frame.planes - 1;
  if (last == 0) {
    float inPlane = inPlaneSlopeAtRest(at.y, at.x, axial, lateral, range_mm);
    return sqrt(max(0.0, 1.0 - inPlane * inPlane));
  }
  int low = max(at.z - 1, 0), high = min(at.z + 1, last);
  float distance_mm = (frame.plane[high].x - frame.plane[low].x) * sd_mm;
  return (boundaryAt(high, at.y, at.x, a, b) - boundaryAt(low, at.y, at.x, a, b)) / distance_mm;
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.nodeColumns - 1 || at.y >= frame.nodeRows - 1) return;
  int corner[4] = int[4](nodeIndex(at.z, at.y, at.x), nodeIndex(at.z, at.y, at.x + 1),
                         nodeIndex(at.z, at.y + 1, at.x), nodeIndex(at.z, at.y + 1, at.x + 1));
  int a = 0, b = 0;
  float nearest = 1e30, second = 1e30;
  for (int c = 0; c < frame.channels; ++c) {
    float sum = nodes[corner[0]].distance_mm[c] + nodes[corner[1]].distance_mm[c] + nodes[corner[2]].distance_mm[c] +
                nodes[corner[3]].distance_mm[c];
    if (sum < nearest) {
      second = nearest, b = a;
      nearest = sum, a = c;
    } else if (sum < second) {
      second = sum, b = c;
    }
  }
  Cell cell;
  cell.a = a, cell.b = b, cell.ct_HU = 0.0, cell.inside = 1;
  for (int q = 0; q < 4; ++q) {
    int n = corner[q];
    cell.s_mm[q] = frame.channels == 1 ? kReach_mm : (nodes[n].distance_mm[b] - nodes[n].distance_mm[a]) / 2.0;
    cell.ct_HU += nodes[n].ct_HU / 4.0;
    cell.comesAndGoes[q] = nodes[n].comesAndGoes, cell.wander_mm[q] = nodes[n].wander_mm;
    if (nodes[n].beyond > 0.0) cell.inside = 0;
  }

  float range_mm = rangeOf((float(at.y) + 0.5) * float(frame.cellGates));
  float spacing_mm = scanlineSpacing(range_mm), sd_mm = gateTableAt(at.y * frame.cellGates).x;
  float axial = (cell.s_mm[2] - cell.s_mm[0] + cell.s_mm[3] - cell.s_mm[1]) / 2.0 /
                (float(frame.cellGates) * frame.gate_mm);
  float lateral = (cell.s_mm[1] - cell.s_mm[0] + cell.s_mm[3] - cell.s_mm[2]) / 2.0 /
                  (float(frame.cellLines) * spacing_mm);
  float elevation = elevationSlope(at, a, b, axial, lateral, range_mm, sd_mm);
  float gradient = length(vec3(axial, lateral, elevation));
  cell.cosine = min(1.0, abs(axial) / max(gradient, kSteepest));
  cell.spread_mm = length(vec2(lateral * spacing_mm, elevation * frame.planeSpacing_sd * sd_mm)) /
                   max(abs(axial), kLeastSlope);
  cells[(at.z * (frame.nodeRows - 1) + at.y) * (frame.nodeColumns - 1) + at.x] = cell;
}
