#pragma once

#include "scene/TissueField.h"

#include <insonate/gpu/Program.h>

#include <array>
#include <cstdint>

/// Structures shared by C++ and the shaders, in the std140 layout: whole groups of four numbers.
namespace insonate::glsl {

struct alignas(16) Float4 {
  float x = 0, y = 0, z = 0, w = 0;
};
struct alignas(16) Int4 {
  std::int32_t x = 0, y = 0, z = 0, w = 0;
};
/// An affine map, row by row: (x, y, z, offset).
using Rows = std::array<Float4, 3>;

/// Number of texture tiles: one per Texture, and one for the variation along boundaries.
inline constexpr int kTiles = 7;
inline constexpr int kMostPlanes = 9;  ///< maximum of ImagingSettings::elevationPlanes

/// Bits of FrameBlock::effects, one for each physical effect that a shader tests; the shader uses the same names.
enum EffectBit : std::int32_t {
  kScattering = 1,
  kReflection = 2,
  kAttenuation = 4,
  kTransmission = 8,
  kSpeckle = 16,
  kLayers = 32,
  kTexture = 64,
  kEdgeShadow = 128,
};

/// Bits of ChannelBlock::flags. kSheets: the texture has sheets, which echo coherently. kGas: the channel is gas.
/// kVessel: the channel is a vessel.
inline constexpr std::int32_t kSheets = 1, kGas = 2, kVessel = 4;

/// Acoustic constants of one channel (structure): mirrors the structure Channel of shaders/frame.glsl.
struct ChannelBlock {
  float loss_dB, echo_dB, ctEcho_dBperHU, impedance_MRayl;
  float ctImpedancePerHU, textureStrength_dB, roughness_dB, specularExponent;
  float specularDiffuse;
  std::int32_t tile, flags, grazed;
  std::array<Rows, 2> tileFromProbe;
  std::array<Int4, 2> tileBase;
  std::array<Float4, 2> thinAxis;
};

/// Parameters of a frame: mirrors the uniform block FrameBlock of shaders/frame.glsl, which describes the fields.
struct FrameBlock {
  std::int32_t lines, gates, samples, looks;
  std::int32_t planes, stride, cellGates, cellLines;
  std::int32_t nodeRows, nodeColumns, gateTable, lateralKernel;
  std::int32_t lateralEntries, axialEntries, upsampleTable, parts;
  float gate_mm, spacingAtFace_mm, spacingPerMm, planeSpacing_sd;
  float boundaryScale, edgeLoss_dB, displacementLeft_mm, displacementTop_mm;
  float displacementStep_mm;
  std::int32_t displacementColumns, displacementRows, effects;
  std::int32_t channels, backgroundChannel, ctWords, profileWords;
  std::int32_t latticeSeed, clampSides, conforming;
  float lungSlide_voxels;
  Int4 fieldSize;
  Rows nodeFromProbe;
  Rows latticeFromProbe;
  Int4 latticeBase;
  Rows patchFromProbe;
  Int4 patchBase;
  Float4 lungDetached_mm;
  std::array<Float4, 2> fromMiddle;
  std::array<Float4, kMostPlanes> plane;
  std::array<Int4, kTiles> tile;
  std::array<ChannelBlock, TissueField::kStride> channel;
};

/// Parameters of the rendering style of the thesis: mirrors the uniform block ThesisBlock of shaders/thesis.glsl.
struct ThesisBlock {
  std::int32_t mapRows, noiseSeed;
  float row_mm, interface_mm, steepness_mm, lossLength_mm;
  float tailShare, noiseAcross, noiseDown, depth_mm, unused0, unused1;
  std::array<Float4, TissueField::kStride> medium, perHU;
};

/// Maximum of ColorBlock::steps: 500 mm, more than the depth of any image.
inline constexpr int kMostColorSteps = 1024;

/// Parameters of color Doppler: mirrors the uniform block ColorBlock of shaders/color.glsl, which describes the fields.
struct ColorBlock {
  std::int32_t fineLines, fineGates, lines, gates;
  std::int32_t lateralMargin, axialMargin, gateKnots, wayKnots;
  std::int32_t lineTable, knotTable, steps, segments;
  std::int32_t profileTable, artery, vein;
  float firstRange_mm;
  float fineGate_mm, turnsPerVelocity, perCutoff, unused;
  Float4 tissue_mmps;
  std::array<Float4, 3> plane;
  std::array<Float4, TissueField::kStride> echoPower;
  std::array<float, TissueField::kStride * TissueField::kStride> transmitted;
};

/// Sizes in bytes of the structures of shaders/records.glsl, which one stage of shaders passes to another.
inline constexpr std::size_t kNodeBytes = 80, kCellBytes = 72, kSampleBytes = 32, kCrossingBytes = 16;

/// frameFields(), thesisFields() and colorFields() return the byte offsets of the fields of FrameBlock, ThesisBlock and
/// ColorBlock in C++, with the shaders' names; for Program::checkBlock().
std::vector<gpu::Field> frameFields();
std::vector<gpu::Field> thesisFields();
std::vector<gpu::Field> colorFields();

}  // namespace insonate::glsl
