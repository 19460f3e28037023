// Positions of scanlines and gates.

layout(std430, binding = 2) readonly buffer Plan {
  vec4 planTable[];  // scanlines: origin x, z, direction x, z; then gates: SD of the slice, scale of scattering,
                     // radius of the lateral kernel, cone of the aperture
};

vec4 gateTableAt(int gate) {
  return planTable[frame.gateTable + clamp(gate, 0, frame.gates - 1)];
}

vec3 pointOn(int line, float range_mm) {
  vec4 ray = planTable[line];
  return vec3(ray.x + ray.z * range_mm, 0, ray.y + ray.w * range_mm);
}

// Skin follows the face, deep tissue stays.
float tissueRange(float range_mm, float gap_mm) {
  return range_mm + gap_mm * exp(-range_mm / kContactDepth_mm);
}

vec3 seenPoint(int plane, int gate, int line, float gap_mm) {
  vec3 seen = pointOn(line, tissueRange(rangeOf(float(gate)), gap_mm));
  seen.y = frame.plane[plane].x * gateTableAt(gate).x;
  return seen;
}
