// A needle's echoes and shadow, as NeedleEchoes has placed them.
layout(std430, binding = 6) readonly buffer NeedleWords {
  // By scanline: first gate, gate after the last, gates from ring to ring, index of the first amplitude; by plane and
  // scanline: gate where the shadow begins, its loss in dB; amplitudes.
  float words[];
};

float shadowAt(int plane, int gate, int line) {
  int at = 4 * frame.lines + 2 * (plane * frame.lines + line);
  return words[at + 1] * clamp(float(gate) - words[at], 0.0, 1.0);
}
