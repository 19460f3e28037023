// The look of the thesis: mirrors ThesisBlock of modules/ultrasound/src/glsl/FrameBlock.h.

layout(std140, binding = 1) uniform ThesisBlock {
  int mapRows, noiseSeed;
  float row_mm, interface_mm, steepness_mm, lossLength_mm;
  float tailShare, noiseAcross, noiseDown, depth_mm;
  vec4 medium[16];  // by channel: ln Z, its change per HU, loss in dB/mm there and back, echo in dB
  vec4 perHU[16];   // echo in dB
} thesis;

// Perlin's quintic step from 0 to 1 and its slope.
float fade(float t) {
  return t * t * t * (10.0 + t * (-15.0 + 6.0 * t));
}

float fadeSlope(float t) {
  return 30.0 * t * t * (1.0 - t) * (1.0 - t);
}
