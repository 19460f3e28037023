// Parameters of a frame: mirrors FrameBlock of modules/ultrasound/src/glsl/FrameBlock.h, compared with it at link
// time. Places are in the probe's frame (mm); rows are (x, y, z, offset).

struct Channel {
  float loss_dB, echo_dB, ctEcho_dBperHU, impedance_MRayl;  // loss per gate, there and back
  float ctImpedancePerHU, textureStrength_dB, roughness_dB, specularExponent;
  float specularDiffuse;
  int tile;   // of its texture; 0: one voxel of nothing
  int flags;  // kSheets, kGas, kVessel
  int grazed;  // a bit for each channel whose boundary with this one is a vessel's
  // By side of the midline, 0 right, 1 left.
  vec4 tileFromProbe[6];  // [side * 3 + row]
  ivec4 tileBase[2];      // whole voxels, added to what the rows give
  vec4 thinAxis[2];
};

layout(std140, binding = 0) uniform FrameBlock {
  int lines, gates, samples, looks;
  int planes, stride, cellGates, cellLines;
  int nodeRows, nodeColumns, gateTable, lateralKernel;  // gateTable, lateralKernel: first entries
  int lateralEntries, axialEntries, upsampleTable, parts;  // parts: 2 of a complex echo, 1 of a real one
  float gate_mm, spacingAtFace_mm, spacingPerMm, planeSpacing_sd;
  float boundaryScale, edgeLoss_dB, displacementLeft_mm, displacementTop_mm;
  float displacementStep_mm;
  int displacementColumns, displacementRows, effects;  // one point: moved alike
  int channels, backgroundChannel, ctWords, profileWords;  // ctWords, profileWords: first words
  int latticeSeed, clampSides, conforming;
  float lungSlide_voxels;  // toward the head, in voxels of what comes and goes
  ivec4 fieldSize;  // nodes; words a node
  vec4 nodeFromProbe[3];
  vec4 latticeFromProbe[3];
  ivec4 latticeBase;
  vec4 patchFromProbe[3];
  ivec4 patchBase;
  vec4 lungDetached_mm;  // right, left: nearer to the trachea a pneumothorax keeps the lung from sliding
  vec4 fromMiddle[2];  // patient's left of the midline, and of the trachea, mm
  vec4 plane[9];     // offset in SD of the slice, weight of scattering, weight of boundaries
  ivec4 tile[7];     // first byte, sizes u, v, w; the last is of what comes and goes along boundaries
  Channel channel[16];
} frame;

bool with(int effect) {
  return (frame.effects & effect) != 0;
}

float rangeOf(float gate) {
  return (gate + 0.5) * frame.gate_mm;
}

float scanlineSpacing(float range_mm) {
  return frame.spacingAtFace_mm + frame.spacingPerMm * range_mm;
}

vec3 carriedBy(vec4 rows[3], vec3 p) {
  vec4 q = vec4(p, 1);
  return vec3(dot(rows[0], q), dot(rows[1], q), dot(rows[2], q));
}

float fromDecibel(float level_dB) {
  return exp2(level_dB * 0.16609640474);
}

float toDecibel(float amplitude) {
  return 6.0205999133 * log2(amplitude);
}

// [plane][gate][line], [component][gate][line]
int gateIndex(int plane, int gate, int line) {
  return (plane * frame.gates + gate) * frame.lines + line;
}

int nodeIndex(int plane, int row, int column) {
  return (plane * frame.nodeRows + row) * frame.nodeColumns + column;
}

int cellIndex(int plane, int gate, int line) {
  int row = gate / frame.cellGates, column = line / frame.cellLines;
  return (plane * (frame.nodeRows - 1) + row) * (frame.nodeColumns - 1) + column;
}
