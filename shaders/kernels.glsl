// The beam's kernels, halves from the center on, and the way from gates to samples.

layout(std430, binding = 5) readonly buffer Kernels {
  float kernel[];  // axial and lateral by gates; weights of four gates by sample
};
layout(std430, binding = 6) readonly buffer Before {
  float before[];
};
layout(std430, binding = 7) writeonly buffer After {
  float after[];
};
