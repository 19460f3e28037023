// Rest position of the tissue seen at a gate.
#include "geometry.glsl"

layout(std430, binding = 3) readonly buffer Contacts {
  vec2 contacts[];  // [column]: gap in mm, strength
};
layout(std430, binding = 4) readonly buffer Shifts {
  vec2 shifts[];  // [row][column], x and z
};

// Between the columns of the lattice.
vec2 contactOf(int line) {
  int column = line / frame.cellLines;
  float t = float(line - column * frame.cellLines) / float(frame.cellLines);
  return mix(contacts[column], contacts[column + 1], t);
}

// Between the nodes of its cell.
vec3 gateShift(int gate, int line) {
  int row = gate / frame.cellGates, column = line / frame.cellLines;
  float down = float(gate - row * frame.cellGates) / float(frame.cellGates);
  float across = float(line - column * frame.cellLines) / float(frame.cellLines);
  int top = nodeIndex(0, row, column), bottom = nodeIndex(0, row + 1, column);
  vec2 shift = mix(mix(shifts[top], shifts[top + 1], across), mix(shifts[bottom], shifts[bottom + 1], across), down);
  return vec3(shift.x, 0, shift.y);
}

vec3 restPoint(int plane, int gate, int line) {
  return seenPoint(plane, gate, line, contactOf(line).x) + gateShift(gate, line);
}
