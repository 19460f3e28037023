// Adds point targets, no gate of a scanline named twice.
#include "frame.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = 5) readonly buffer Points {
  vec4 points[];  // gate, scanline, amplitude
};
layout(std430, binding = 7) buffer Echoes {
  float echoes[];
};

void main() {
  int n = int(gl_GlobalInvocationID.x);
  if (n >= frame.points) return;
  vec4 point = points[n];
  for (int look = 0; look < frame.looks; ++look)
    echoes[gateIndex(2 * look, int(point.x), int(point.y))] += point.z;
}
