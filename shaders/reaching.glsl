// Amplitude, there and back, that reaches a gate, as its own scanline lets it pass: the mean over the planes.

const float kNoContact = 1e-9;

float reachingAt(int gate, int line) {
  if (gate == 0) return max(contactOf(line).y, kNoContact);
  float sum = 0.0;
  for (int plane = 0; plane < frame.planes; ++plane) {
    GateSample above = samples[gateIndex(plane, gate - 1, line)];
    sum += frame.plane[plane].z * fromDecibel(above.level_dB - above.loss_dB / 2.0);
  }
  return max(sum, kFaintest);
}
