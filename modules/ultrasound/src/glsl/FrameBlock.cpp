#include "glsl/FrameBlock.h"

#include <cstddef>

namespace insonate::glsl {

#define FRAME(name) \
  { "FrameBlock." #name, offsetof(FrameBlock, name) }
#define FRAME_ARRAY(name) \
  { "FrameBlock." #name "[0]", offsetof(FrameBlock, name) }
#define CHANNEL(name) \
  { "FrameBlock.channel[0]." #name, offsetof(FrameBlock, channel) + offsetof(ChannelBlock, name) }
#define CHANNEL_ARRAY(name) \
  { "FrameBlock.channel[0]." #name "[0]", offsetof(FrameBlock, channel) + offsetof(ChannelBlock, name) }
#define THESIS(name) \
  { "ThesisBlock." #name, offsetof(ThesisBlock, name) }
#define THESIS_ARRAY(name) \
  { "ThesisBlock." #name "[0]", offsetof(ThesisBlock, name) }
#define COLOR(name) \
  { "ColorBlock." #name, offsetof(ColorBlock, name) }
#define COLOR_ARRAY(name) \
  { "ColorBlock." #name "[0]", offsetof(ColorBlock, name) }

static std::vector<gpu::Field> channelFields() {
  return {CHANNEL(loss_dB),
          CHANNEL(echo_dB),
          CHANNEL(ctEcho_dBperHU),
          CHANNEL(impedance_MRayl),
          CHANNEL(ctImpedancePerHU),
          CHANNEL(textureStrength_dB),
          CHANNEL(roughness_dB),
          CHANNEL(specularExponent),
          CHANNEL(specularDiffuse),
          CHANNEL(tile),
          CHANNEL(flags),
          CHANNEL(grazed),
          CHANNEL_ARRAY(tileFromProbe),
          CHANNEL_ARRAY(tileBase),
          CHANNEL_ARRAY(thinAxis)};
}

std::vector<gpu::Field> frameFields() {
  std::vector<gpu::Field> fields{FRAME(lines),
                                 FRAME(gates),
                                 FRAME(samples),
                                 FRAME(looks),
                                 FRAME(planes),
                                 FRAME(stride),
                                 FRAME(cellGates),
                                 FRAME(cellLines),
                                 FRAME(nodeRows),
                                 FRAME(nodeColumns),
                                 FRAME(gateTable),
                                 FRAME(lateralKernel),
                                 FRAME(lateralEntries),
                                 FRAME(axialEntries),
                                 FRAME(upsampleTable),
                                 FRAME(parts),
                                 FRAME(gate_mm),
                                 FRAME(spacingAtFace_mm),
                                 FRAME(spacingPerMm),
                                 FRAME(planeSpacing_sd),
                                 FRAME(boundaryScale),
                                 FRAME(edgeLoss_dB),
                                 FRAME(displacementLeft_mm),
                                 FRAME(displacementTop_mm),
                                 FRAME(displacementStep_mm),
                                 FRAME(displacementColumns),
                                 FRAME(displacementRows),
                                 FRAME(effects),
                                 FRAME(channels),
                                 FRAME(backgroundChannel),
                                 FRAME(ctWords),
                                 FRAME(profileWords),
                                 FRAME(latticeSeed),
                                 FRAME(clampSides),
                                 FRAME(conforming),
                                 FRAME(lungSlide_voxels),
                                 FRAME(fieldSize),
                                 FRAME_ARRAY(nodeFromProbe),
                                 FRAME_ARRAY(latticeFromProbe),
                                 FRAME(latticeBase),
                                 FRAME_ARRAY(patchFromProbe),
                                 FRAME(patchBase),
                                 FRAME(lungDetached_mm),
                                 FRAME_ARRAY(fromMiddle),
                                 FRAME_ARRAY(plane),
                                 FRAME_ARRAY(tile)};
  const std::vector<gpu::Field> channel = channelFields();
  fields.insert(fields.end(), channel.begin(), channel.end());
  return fields;
}

std::vector<gpu::Field> thesisFields() {
  return {THESIS(mapRows),      THESIS(noiseSeed),     THESIS(row_mm),       THESIS(interface_mm),
          THESIS(steepness_mm), THESIS(lossLength_mm), THESIS(tailShare),    THESIS(noiseAcross),
          THESIS(noiseDown),    THESIS(depth_mm),      THESIS_ARRAY(medium), THESIS_ARRAY(perHU)};
}

std::vector<gpu::Field> colorFields() {
  return {COLOR(fineLines),
          COLOR(fineGates),
          COLOR(lines),
          COLOR(gates),
          COLOR(lateralMargin),
          COLOR(axialMargin),
          COLOR(gateKnots),
          COLOR(wayKnots),
          COLOR(lineTable),
          COLOR(knotTable),
          COLOR(steps),
          COLOR(segments),
          COLOR(profileTable),
          COLOR(artery),
          COLOR(vein),
          COLOR(firstRange_mm),
          COLOR(fineGate_mm),
          COLOR(turnsPerVelocity),
          COLOR(perCutoff),
          COLOR(tissue_mmps),
          COLOR_ARRAY(plane),
          COLOR_ARRAY(echoPower),
          COLOR_ARRAY(transmitted)};
}

}  // namespace insonate::glsl
