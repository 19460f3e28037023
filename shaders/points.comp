// Adds point targets, no gate of a scanline named twice.
#include "frame.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = 5) readonly buffer Points {
  vec4 points[];  // gate, scanline, amplitude
};
layout(std430, binding = 7) buffer Echoes {
  float echoes[];
};

void main() {
  vec4 point = points[gl_WorkGroupID.x];
  for (int look = 0; look < frame.looks; ++look)
    echoes[gateIndex(2 * look, int(point.x), int(point.y))] += point.z;
}
