#pragma once

#include "model/Contact.h"
#include "model/FramePlan.h"
#include "model/NeedleEchoes.h"
#include "model/Scatterers.h"
#include "scene/SceneData.h"

#include <insonate/image/PlaneDisplacement.h>

#include <hwy/aligned_allocator.h>

#include <array>
#include <cstdint>
#include <vector>

namespace insonate::cpu {

/// Scanlines are traced in blocks of this many, one task a block; a multiple of every vector length up to 16 lanes.
inline constexpr int kBlockLines = 32;
inline constexpr int kMaxColumns = kBlockLines + 16;  ///< node columns of a block, with room for a vector's tail
inline constexpr int kMaxPlanes = 9;

template <class T>
using AlignedArray = hwy::AlignedFreeUniquePtr<T[]>;

/// A linear map as floats, rows by rows.
struct FloatMatrix {
  float xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;

  FloatMatrix() = default;
  explicit FloatMatrix(const Mat3& m) {
    const auto& c = m.column;
    const auto f = [](double v) { return static_cast<float>(v); };
    xx = f(c[0].x), xy = f(c[1].x), xz = f(c[2].x);
    yx = f(c[0].y), yy = f(c[1].y), yz = f(c[2].y);
    zx = f(c[0].z), zy = f(c[1].z), zz = f(c[2].z);
  }
};

/// Directions of the probe's lateral and axial axes in another frame, per mm: they convert a shift in the plane to
/// that frame.
struct PlaneAxes {
  struct {
    float x = 0, y = 0, z = 0;
  } lateral, axial;

  PlaneAxes() = default;
  explicit PlaneAxes(const Mat3& targetFromProbe) {
    const FloatMatrix m(targetFromProbe);
    lateral = {m.xx, m.yx, m.zx}, axial = {m.xz, m.yz, m.zz};
  }
};

/// Acoustic constants of one channel of the tissue field, floats for the kernels.
struct ChannelConstants {
  float halfway = 1;  ///< share of the amplitude, there and back, that half a gate lets pass
  float echo_dB = 0, ctEcho_dBperHU = 0;
  float impedance = 0, ctImpedancePerHU = 0;
  float textureStrength_dB = 0;
  bool sheets = false;
  const AcousticTissue* tissue = nullptr;
  const TextureTile* tile = nullptr;
};

/// Patient-frame geometry of scanlines (or node columns), one array a coordinate.
struct RayArrays {
  std::vector<float> x, y, z, dx, dy, dz;
  void resize(std::size_t n) {
    for (auto* a : {&x, &y, &z, &dx, &dy, &dz}) a->resize(n);
  }
};

/// The scanlines in a texture tile, in voxels; half a voxel less than where they are, so that the nearest whole number
/// is the voxel.
struct TextureRays {
  RayArrays line;
  PlaneAxes axes;                                        ///< voxels per mm in the plane
  float elevationX = 0, elevationY = 0, elevationZ = 0;  ///< voxels per mm across the slice
  std::vector<float> facing;                             ///< share of a sheet's echo that comes back, see sheetFacing()
};

/// All that the trace of one frame reads; filled by the engine, shared by its tasks.
struct TraceInput {
  const FramePlan* plan = nullptr;
  const AcousticScene::Impl* scene = nullptr;
  ChannelConstants channels[TissueField::kStride];
  float halfwayEdge[TissueField::kStride * TissueField::kStride]{};  ///< what a vessel's edge lets pass of it, by pair
  std::uint32_t gasChannels = 0, texturedChannels = 0;               ///< a bit each
  bool anyCt = false;
  const PlaneDisplacement* displacement = nullptr;  ///< null where nothing has moved
  const NeedleEchoes* needle = nullptr;             ///< null where there is none
  RayArrays lines, columns;                         ///< lines padded to whole blocks
  RayArrays probeColumns;                           ///< in the probe frame
  PlaneAxes patientAxes, latticeAxes;
  std::vector<float> lineGap_mm, lineStrength;  ///< contact
  std::vector<float> columnGap_mm;
  std::vector<float> contactDecay;                       ///< [gate or node row's gate]
  std::vector<float> elevation_mm;                       ///< [plane][gate]
  std::vector<float> scatterScale;                       ///< [plane][gate]
  RayArrays latticeLines;                                ///< the scanlines in the scatterers' lattice
  TextureRays textureRays[TissueField::kStride][2];      ///< of textured channels, right and left of the midline
  float elevationX = 0, elevationY = 0, elevationZ = 0;  ///< unit, patient
  float latticeElevationX = 0, latticeElevationY = 0, latticeElevationZ = 0;
  std::uint32_t latticeSeed = 0;
  FloatMatrix nodeFromPatient;
  float nodeOffsetX = 0, nodeOffsetY = 0, nodeOffsetZ = 0;
};

inline constexpr std::int32_t kNoGasYet = -1, kNoGasEver = -2;

/// Result of the trace of one block, before the beam.
struct BlockEchoes {
  alignas(64) std::int32_t gasGate[kBlockLines];  ///< first gate in gas behind tissue
  /// Scattering over what reaches a gate, [component][gate][kBlockLines], component = 2 * look + (0 re, 1 im).
  AlignedArray<float> echo;
  AlignedArray<float> boundaries;  ///< of all looks, as their own scanline reaches them, [gate][kBlockLines]
  /// Amplitude in the middle of each gate in the central plane, there and back, without the needle's shadow,
  /// [gate][kBlockLines]; unused where there is no needle.
  AlignedArray<float> level;
};

/// Per-thread scratch of the trace.
struct TraceBuffers {
  /// Distances at one row of nodes, [channel][column], by plane and parity of the row.
  struct NodeRow {
    alignas(64) float distance[TissueField::kStride][kMaxColumns];
    alignas(64) float ct[kMaxColumns];
    alignas(64) float patch[kMaxColumns], wander_steps[kMaxColumns];
    alignas(64) float inside[kMaxColumns];                                      ///< 1 or 0
    alignas(64) float least[TissueField::kStride], most[TissueField::kStride];  ///< of each channel's distances
  };
  /// Way from where tissue is seen to where it lay at rest, at one row of nodes, in the probe's plane, mm: at its
  /// columns and spread to scanlines. By parity of the row; unused where nothing has moved.
  struct ShiftRow {
    alignas(64) float columnX[kMaxColumns], columnZ[kMaxColumns], lineX[kBlockLines], lineZ[kBlockLines];
  };
  /// One row of grid cells, interpolated to the scanlines.
  struct CellRow {
    alignas(64) float sTop[kBlockLines], sBottom[kBlockLines];
    alignas(64) float cosine[kBlockLines], facing_dB[kBlockLines];
    /// Strength of boundaries and the shift of their layers, in steps of the profile, at the cell's upper and lower
    /// edge.
    alignas(64) float patchTop[kBlockLines], patchBottom[kBlockLines];
    alignas(64) float wanderTop_steps[kBlockLines], wanderBottom_steps[kBlockLines];
    alignas(64) float spread[kBlockLines];  ///< of a boundary's echo, gates
    alignas(64) float echoA[kBlockLines], echoB[kBlockLines], halfwayA[kBlockLines], halfwayB[kBlockLines];
    alignas(64) float impedanceA[kBlockLines], impedanceB[kBlockLines];
    alignas(64) float halfwayEdge[kBlockLines], inside[kBlockLines];
    alignas(64) std::int32_t channelA[kBlockLines], channelB[kBlockLines], profile[kBlockLines];
    std::uint32_t channelsPresent = 0;  ///< bit per channel that any cell of the row names
    bool nearBoundary = false;          ///< some cell is within reach of a boundary's layers or edge
  };
  /// State of each scanline on its way down.
  struct LineState {
    alignas(64) float amplitude[kBlockLines];  ///< that is left of the beam, there and back; 0 beyond what is known
    alignas(64) float s[kBlockLines];
    alignas(64) float impedance[kBlockLines];
    alignas(64) std::int32_t channel[kBlockLines];  ///< -1 before the first gate
    alignas(64) std::int32_t pair[kBlockLines];
  };

  ShiftRow shift[2];
  NodeRow nodes[kMaxPlanes][2];
  CellRow cells[kMaxPlanes];
  LineState state[kMaxPlanes];
  alignas(64) float reaching[kBlockLines];  ///< mean amplitude of the planes before the next gate
  alignas(64) std::int32_t tissueSeen[kBlockLines];
};

struct TraceTimes_ms {
  double nodes = 0, gates = 0;
};

class ApertureTransmission;

/// Fills the constants of the scene's channels.
void setChannels(const AcousticScene::Impl& scene, TraceInput& input);

/// Echoes of the scanlines firstLine .. firstLine + kBlockLines - 1 on all gates, before the beam, and the share of it
/// that each gate lets pass.
void traceBlock(const TraceInput& input, int firstLine, TraceBuffers& buffers, BlockEchoes& echoes,
                ApertureTransmission& transmission, TraceTimes_ms& times);

}  // namespace insonate::cpu
