#pragma once

#include "scene/TissueField.h"

#include <insonate/gpu/Program.h>

#include <array>
#include <cstdint>

/// Structures that C++ and the shaders share, by the layout std140: whole groups of four numbers.
namespace insonate::glsl {

struct alignas(16) Float4 {
  float x = 0, y = 0, z = 0, w = 0;
};
struct alignas(16) Int4 {
  std::int32_t x = 0, y = 0, z = 0, w = 0;
};
/// An affine map into some frame, rows by rows: (x, y, z, offset).
using Rows = std::array<Float4, 3>;

inline constexpr int kTiles = 7;       ///< of textures, by Texture; then of what comes and goes along boundaries
inline constexpr int kMostPlanes = 9;  ///< see ImagingSettings

/// Bit of each physical effect that a shader tests, by its name there.
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

/// Bits of ChannelBlock::flags.
inline constexpr std::int32_t kSheets = 1, kGas = 2;

/// Channel of shaders/frame.glsl.
struct ChannelBlock {
  float loss_dB, echo_dB, ctEcho_dBperHU, impedance_MRayl;
  float ctImpedancePerHU, textureStrength_dB, roughness_dB, specularExponent;
  float specularDiffuse;
  std::int32_t tile, flags, grazed;
  std::array<Rows, 2> tileFromProbe;
  std::array<Int4, 2> tileBase;
  std::array<Float4, 2> thinAxis;
};

/// FrameBlock of shaders/frame.glsl, which says what each is.
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
  Int4 fieldSize;
  Rows nodeFromProbe;
  Rows latticeFromProbe;
  Int4 latticeBase;
  Rows patchFromProbe;
  Int4 patchBase;
  Float4 fromMidline;
  std::array<Float4, kMostPlanes> plane;
  std::array<Int4, kTiles> tile;
  std::array<ChannelBlock, TissueField::kStride> channel;
};

/// ThesisBlock of shaders/thesis.glsl.
struct ThesisBlock {
  std::int32_t mapRows, noiseSeed;
  float row_mm, interface_mm, steepness_mm, lossLength_mm;
  float tailShare, noiseAcross, noiseDown, depth_mm, unused0, unused1;
  std::array<Float4, TissueField::kStride> medium, perHU;
};

/// Sizes of the records of shaders/records.glsl.
inline constexpr std::size_t kNodeBytes = 80, kCellBytes = 72, kSampleBytes = 32, kCrossingBytes = 16;

/// Offsets of the fields in C++, by the shaders' names; for Program::checkBlock().
std::vector<gpu::Field> frameFields();
std::vector<gpu::Field> thesisFields();

}  // namespace insonate::glsl
