// Tissue at each node of the lattice in beam coordinates.
#include "frame.glsl"
#include "records.glsl"
#include "field.glsl"
#include "tiles.glsl"
#include "geometry.glsl"
#include "displacement.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 3) readonly buffer Contacts {
  vec2 contacts[];
};
layout(std430, binding = 4) writeonly buffer Shifts {
  vec2 shifts[];
};
layout(std430, binding = 5) writeonly buffer Nodes {
  Node nodes[];
};

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.nodeColumns || at.y >= frame.nodeRows) return;
  vec3 seen = seenPoint(at.z, at.y * frame.cellGates, at.x * frame.cellLines, contacts[at.x].x);
  vec3 shift = shiftAt(seen);
  if (at.z == 0) shifts[nodeIndex(0, at.y, at.x)] = shift.xz;
  vec3 rest = seen + shift;
  FieldCell cell = fieldCellAt(carriedBy(frame.nodeFromProbe, rest));

  // Tissue from beyond the scene reads as its outermost.
  float beyond = min(cell.beyond, fieldCellAt(carriedBy(frame.nodeFromProbe, seen)).beyond);
  const float kZero[16] = float[16](0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
  Node node = Node(kZero, 0.0, comesAndGoesBetween(rest, ivec3(0)),
                   kLayerWander_mm * comesAndGoesBetween(rest, ivec3(kWanderStep_voxels)), beyond);
  for (int corner = 0; corner < 8; ++corner) {
    int offset = cornerOffset(cell, corner);
    float weight = cornerWeight(cell, corner);
    for (int c = 0; c < frame.channels; ++c)
      node.distance_mm[c] += weight * distanceAt(offset, c);
    node.ct_HU += weight * halfWord(sceneWord[frame.ctWords + (offset >> 1)], offset & 1);
  }
  nodes[nodeIndex(at.z, at.y, at.x)] = node;
}
