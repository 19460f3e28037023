// Parameters of color Doppler: mirrors ColorBlock of modules/ultrasound/src/glsl/FrameBlock.h; and the contact.

layout(std140, binding = 1) uniform ColorBlock {
  int fineLines, fineGates, lines, gates;
  int lateralMargin, axialMargin, gateKnots, wayKnots;  // knots of a scanline, see color_rest.comp
  int lineTable, knotTable, steps, segments;            // lineTable, knotTable: first entries; steps: of transmission
  int profileTable, artery, vein;                       // profileTable: first entry; channels of vessels, -1: none
  float firstRange_mm;                                  // of the fine gates
  float fineGate_mm, turnsPerVelocity, perCutoff;       // perCutoff: turns at the wall filter's cutoff; 0: no filter
  vec4 tissue_mmps;
  vec4 plane[3];         // offset in mm, weight
  vec4 echoPower[16];    // by channel; the first component
  vec4 transmitted[64];  // power, by the channels before and behind a step; four a vector
} color;

layout(std430, binding = 3) readonly buffer Contacts {
  vec2 contacts[];  // gap in mm, strength
};

vec2 contactAt(float column) {
  int low = min(int(column), kContactColumns - 2);
  return mix(contacts[low], contacts[low + 1], column - float(low));
}

int restIndex(int line, int knot) {
  return line * (color.gateKnots + color.wayKnots) + knot;
}

// [component][line][gate]
int fineIndex(int component, int line, int gate) {
  return (component * color.fineLines + line) * color.fineGates + gate;
}
