// Tissue at rest along scanlines of color.

layout(std430, binding = 5) readonly buffer Rests {
  vec2 rests[];
};

// Between two knots; `first` is the first knot of the points.
vec2 restBetween(int line, int first, int point) {
  int n = restIndex(line, first + point / kKnotStep);
  return mix(rests[n], rests[n + 1], float(point % kKnotStep) / float(kKnotStep));
}

// Writes the distances to all structures, and returns the channel of the nearest.
int lookUp(vec3 rest_mm, out float distance_mm[16]) {
  FieldCell cell = fieldCellAt(carriedBy(frame.nodeFromProbe, rest_mm));
  for (int c = 0; c < frame.channels; ++c) distance_mm[c] = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    int offset = cornerOffset(cell, corner);
    float weight = cornerWeight(cell, corner);
    for (int c = 0; c < frame.channels; ++c) distance_mm[c] += weight * distanceAt(offset, c);
  }
  int nearest = 0;
  for (int c = 1; c < frame.channels; ++c)
    if (distance_mm[c] < distance_mm[nearest]) nearest = c;
  return nearest;
}
