// Records that stages hand to each other.

struct Node {
  float distance_mm[16];
  float ct_HU, comesAndGoes, wander_mm, beyond;  // comesAndGoes: unit SD; beyond: the lattice, in nodes
};

struct Cell {
  int a, b;       // the two nearest structures
  float s_mm[4];  // at the corners: row, then column
  float comesAndGoes[4];
  float wander_mm[4];
  float cosine, spread_mm, ct_HU;
  int inside;
};

// At a gate, from the corners of its cell.
float withinCell(float corner[4], int gate, int line) {
  float down = float(gate % frame.cellGates) / float(frame.cellGates);
  float across = float(line % frame.cellLines) / float(frame.cellLines);
  return mix(mix(corner[0], corner[1], across), mix(corner[2], corner[3], across), down);
}

struct GateSample {
  float s_mm, impedance_MRayl, loss_dB, level_dB;  // level: in the middle of the gate
  float echo_dB, sheet;
  int channel;
  int marks;
};
const int kInside = 1, kOutside = 2, kGasHere = 4;  // outside: before the skin, gel

// Between a gate and the one before.
struct Crossing {
  float echo, fraction, width, loss_dB;  // fraction: from the gate before; width: gates
};
