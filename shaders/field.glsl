// Signed distances to the structures, and the CT, on the scene's lattice.

layout(std430, binding = 0) readonly buffer Scene {
  int sceneWord[];  // distances by node, 2 a word; CT deviations, 2 a word; boundary profiles
};

struct FieldCell {
  ivec3 low, high;
  vec3 fraction;
  float beyond;  // the lattice, in nodes; 0 within half a node of it
};

FieldCell fieldCellAt(vec3 node) {
  FieldCell cell;
  vec3 last = vec3(frame.fieldSize.xyz - 1);
  vec3 off = max(-0.5 - node, node - (last + 0.5));
  cell.beyond = max(max(off.x, off.y), max(off.z, 0.0));
  vec3 at = clamp(node, vec3(0), last);
  cell.low = min(ivec3(at), max(frame.fieldSize.xyz - 2, 0));
  cell.high = min(cell.low + 1, frame.fieldSize.xyz - 1);
  cell.fraction = at - vec3(cell.low);
  return cell;
}

int cornerOffset(FieldCell cell, int corner) {
  ivec3 n = ivec3((corner & 1) != 0 ? cell.high.x : cell.low.x, (corner & 2) != 0 ? cell.high.y : cell.low.y,
                  (corner & 4) != 0 ? cell.high.z : cell.low.z);
  return (n.z * frame.fieldSize.y + n.y) * frame.fieldSize.x + n.x;
}

float cornerWeight(FieldCell cell, int corner) {
  vec3 f = cell.fraction;
  return ((corner & 1) != 0 ? f.x : 1.0 - f.x) * ((corner & 2) != 0 ? f.y : 1.0 - f.y) *
         ((corner & 4) != 0 ? f.z : 1.0 - f.z);
}

// One of the two 16-bit numbers of a word.
float halfWord(int word, int which) {
  return float(bitfieldExtract(word, 16 * which, 16));
}

float distanceAt(int node, int channel) {
  return halfWord(sceneWord[frame.fieldSize.w * node + (channel >> 1)], channel & 1) / kUnitsPerMm;
}
