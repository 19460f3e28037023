// A needle's echoes and shadow, as NeedleEchoes has placed them.
layout(std430, binding = 6) readonly buffer NeedleWords {
  // By scanline: first gate, gate after the last, gates from ring to ring, index of the first amplitude; by plane and
  // scanline: gate where the shadow begins, its loss in dB; amplitudes.
  float words[];
};

// Where a gate lies on the way through tissue.
float tissueGate(int gate, int line) {
  return tissueRange(rangeOf(float(gate)), contactOf(line).x) / frame.gate_mm - 0.5;
}

float shadowAt(int plane, int gate, int line) {
  int at = 4 * frame.lines + 2 * (plane * frame.lines + line);
  return words[at + 1] * clamp(tissueGate(gate, line) - words[at], 0.0, 1.0);
}
