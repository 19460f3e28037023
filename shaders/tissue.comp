// Tissue at each gate: TissueLookup::at().
#include "frame.glsl"
#include "records.glsl"
#include "field.glsl"
#include "tiles.glsl"
#include "rest.glsl"

layout(local_size_x = 32, local_size_y = 2) in;
layout(std430, binding = 5) readonly buffer Cells {
  Cell cells[];
};
layout(std430, binding = 6) writeonly buffer Samples {
  GateSample samples[];
};

const float kSilence_dB = -1e4, kLost_dB = 1e4;

// Structure that a CT does not resolve.
void addTexture(inout GateSample here, float ct_HU, vec3 rest, int line) {
  // Read in place: of a copy of the channel, NVIDIA's compiler (580.159) takes wrong rows where `side` varies.
  int own = here.channel;
  here.echo_dB += frame.channel[own].ctEcho_dBperHU * ct_HU;
  int side = dot(frame.fromMiddle[0], vec4(rest, 1)) < 0.0 ? 0 : 1;
  vec4 rows[3] = vec4[3](frame.channel[own].tileFromProbe[3 * side], frame.channel[own].tileFromProbe[3 * side + 1],
                         frame.channel[own].tileFromProbe[3 * side + 2]);
  ivec3 voxel = frame.channel[own].tileBase[side].xyz + ivec3(floor(carriedBy(rows, rest)));
  float value = tileAt(frame.channel[own].tile, voxel) / 127.0;
  if (value > 0.0) {
    vec4 ray = planTable[line];
    float facing = dot(vec3(ray.z, 0, ray.w), frame.channel[own].thinAxis[side].xyz);
    value *= 0.2 + 0.8 * facing * facing;
    if ((frame.channel[own].flags & kSheets) != 0) here.sheet = kSheetCoherence * value;
  }
  here.echo_dB += frame.channel[own].textureStrength_dB * value;
}

float byteOf(int word, int which) {
  return float(bitfieldExtract(uint(word), 8 * which, 8));
}

// Connective layers at the boundary take over from the tissue.
void addLayers(inout GateSample here, Cell cell, int gate, int line) {
  float wander_mm = withinCell(cell.wander_mm, gate, line);
  int entry = int(floor((here.s_mm + wander_mm) / kProfileStep_mm)) + kProfileEntries / 2;
  if (entry < 0 || entry >= kProfileEntries) return;
  int word = sceneWord[frame.profileWords + (cell.a * frame.channels + cell.b) * kProfileEntries + entry];
  // layerCover() of model/Boundary.h.
  float patchHere = withinCell(cell.comesAndGoes, gate, line);
  float presence = clamp(kLayerPresence + kLayerPresencePerPatch * patchHere, 0.0, 1.0);
  float occupancy = max(0.0, byteOf(word, 0) / 255.0 - byteOf(word, 3) / 255.0 * (1.0 - presence));
  float anisotropy = byteOf(word, 2) / 255.0;
  float facing_dB = toDecibel(0.12 + 0.88 * cell.cosine * cell.cosine);
  float layer_dB = byteOf(word, 1) / 4.0 - 32.0 + anisotropy * facing_dB;
  here.echo_dB += occupancy * (layer_dB - here.echo_dB);
  here.sheet += occupancy * (kSheetCoherence * anisotropy - here.sheet);
}

void main() {
  ivec3 at = ivec3(gl_GlobalInvocationID);
  if (at.x >= frame.lines || at.y >= frame.gates) return;
  int line = at.x, gate = at.y, plane = at.z;
  Cell cell = cells[cellIndex(plane, gate, line)];

  GateSample here;
  here.s_mm = withinCell(cell.s_mm, gate, line);
  here.channel = here.s_mm >= 0.0 ? cell.a : cell.b;
  Channel channel = frame.channel[here.channel];
  bool outside = here.channel == frame.backgroundChannel && rangeOf(float(gate)) < kContactReach_mm;
  here.marks = (cell.inside != 0 ? kInside : 0) | (outside ? kOutside : 0) |
               ((channel.flags & kGas) != 0 && !outside && cell.inside != 0 ? kGasHere : 0);
  here.impedance_MRayl =
      channel.impedance_MRayl * (1.0 + (with(kTexture) ? channel.ctImpedancePerHU * cell.ct_HU : 0.0));

  bool grazes = (frame.channel[cell.a].grazed >> cell.b & 1) != 0 && abs(here.s_mm) < kEdgeReach_mm &&
                cell.cosine < kEdgeCosine;
  here.loss_dB = channel.loss_dB + (grazes && with(kEdgeShadow) ? frame.edgeLoss_dB : 0.0);
  if (!with(kAttenuation) || outside) here.loss_dB = 0.0;
  if (cell.inside == 0) here.loss_dB = kLost_dB;

  here.echo_dB = channel.echo_dB, here.sheet = 0.0;
  if (with(kTexture)) addTexture(here, cell.ct_HU, restPoint(plane, gate, line), line);
  if (with(kLayers)) addLayers(here, cell, gate, line);
  if (outside || !with(kScattering)) here.echo_dB = kSilence_dB;
  samples[gateIndex(plane, gate, line)] = here;
}
