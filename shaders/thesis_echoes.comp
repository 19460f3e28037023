// Reflection, absorption and speckle of the look of the thesis, all elevation planes. Losses are summed down the
// scanline as in levels.comp.
#include "frame.glsl"
#include "thesis.glsl"
#include "hash.glsl"
#include "rest.glsl"

layout(local_size_x = 16, local_size_y = 16) in;
layout(std430, binding = 5) readonly buffer Map {
  vec4 map[];
};
layout(std430, binding = 7) buffer Echoes {
  float echoes[];
};

shared float total_dB[9][16][16];  // [plane][part][scanline]

vec3 mapAt(int plane, int gate, int line) {
  float place = 2.0 * float(gate) / float(frame.cellGates);
  int row = int(place), column = line / frame.cellLines;
  float across = float(line % frame.cellLines) / float(frame.cellLines);
  int top = (plane * thesis.mapRows + row) * frame.nodeColumns + column, bottom = top + frame.nodeColumns;
  return mix(mix(map[top].xyz, map[top + 1].xyz, across), mix(map[bottom].xyz, map[bottom + 1].xyz, across),
             place - float(row));
}

float vertexAt(ivec2 cell, vec2 d, ivec2 corner, uint seed) {
  uint h = hashNode(ivec3(cell + corner, 0), seed);
  vec2 gradient = vec2(h & 0xffffu, h >> 16) / 32767.5 - 1.0;
  return dot(gradient, d - vec2(corner));
}

float perlin(vec2 p, uint seed) {
  vec2 low = floor(p), d = p - low;
  ivec2 cell = ivec2(low);
  float above = mix(vertexAt(cell, d, ivec2(0, 0), seed), vertexAt(cell, d, ivec2(1, 0), seed), fade(d.x));
  float below = mix(vertexAt(cell, d, ivec2(0, 1), seed), vertexAt(cell, d, ivec2(1, 1), seed), fade(d.x));
  return mix(above, below, fade(d.y));
}

float speckleAt(int gate, int line) {
  vec2 at = vec2((float(line) + 0.5) / float(frame.lines), rangeOf(float(gate)) / thesis.depth_mm);
  float noise = 0.0, scale = 1.0;
  for (int octave = 0; octave < kNoiseOctaves; ++octave, scale *= 2.0) {
    uint seed = hash32(uint(thesis.noiseSeed) + 0x9e3779b9u * uint(octave + 1));
    noise += perlin(at * vec2(thesis.noiseAcross, thesis.noiseDown) * scale, seed) / scale;
  }
  float factor = 1.0 + kSpeckleContrast * noise / kNoiseSd;
  return max(0.0, factor) / sqrt(1.0 + kSpeckleContrast * kSpeckleContrast);
}

void main() {
  int line = min(int(gl_GlobalInvocationID.x), frame.lines - 1);
  bool writes = int(gl_GlobalInvocationID.x) < frame.lines;
  // The last threads take the first gates, so that a missing barrier shows where threads run in their order.
  int part = 15 - int(gl_LocalInvocationID.y), column = int(gl_LocalInvocationID.x);
  int length_ = (frame.gates + 15) / 16;
  int first = part * length_, end = min(first + length_, frame.gates);
  for (int plane = 0; plane < frame.planes; ++plane) {
    float sum_dB = 0.0;
    for (int gate = first; gate < end; ++gate) sum_dB += mapAt(plane, gate, line).y * frame.gate_mm;
    total_dB[plane][part][column] = sum_dB;
  }
  barrier();
  for (int plane = 0; plane < frame.planes; ++plane) {
    float level_dB = toDecibel(max(contactOf(line).y, 1e-9));
    for (int before = 0; before < part; ++before) level_dB -= total_dB[plane][before][column];
    for (int gate = first; gate < end && writes; ++gate) {
      vec3 here = mapAt(plane, gate, line);
      float loss_dB = here.y * frame.gate_mm;
      float amplitude = frame.plane[plane].z * fromDecibel(level_dB - loss_dB / 2.0);
      level_dB -= loss_dB;
      float echo = amplitude * (here.z * (with(kSpeckle) ? speckleAt(gate, line) : 1.0) + here.x);
      int n = gateIndex(0, gate, line);
      echoes[n] = echo + (plane > 0 ? echoes[n] : 0.0);
    }
  }
}
