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

/// Number of scanlines of a block. One task traces one block; the number is a multiple of every vector length up to 16
/// lanes.
inline constexpr int kBlockLines = 32;
inline constexpr int kMaxColumns = kBlockLines + 16;  ///< node columns of a block, including the remainder of a vector
inline constexpr int kMaxPlanes = 9;

template <class T>
using AlignedArray = hwy::AlignedFreeUniquePtr<T[]>;

/// A linear map as floats, row by row.
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

/// Directions of the probe's lateral and axial axes in another frame, per mm. They convert a shift in the plane to that
/// frame.
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

/// Acoustic constants of one channel of the tissue field, as floats for the kernels.
struct ChannelConstants {
  float halfway = 1;  ///< two-way share of the amplitude that half a gate passes
  float echo_dB = 0, ctEcho_dBperHU = 0;
  float impedance = 0, ctImpedancePerHU = 0;
  float textureStrength_dB = 0;
  bool sheets = false;
  const AcousticTissue* tissue = nullptr;
  const TextureTile* tile = nullptr;
};

/// Geometry of scanlines (or node columns) in the patient frame, one array per coordinate.
struct RayArrays {
  std::vector<float> x, y, z, dx, dy, dz;
  void resize(std::size_t n) {
    for (auto* a : {&x, &y, &z, &dx, &dy, &dz}) a->resize(n);
  }
};

/// The scanlines in voxels of a texture tile, shifted by minus half a voxel, so that rounding to the nearest whole
/// number gives the voxel.
struct TextureRays {
  RayArrays line;
  PlaneAxes axes;                                        ///< voxels per mm in the plane
  float elevationX = 0, elevationY = 0, elevationZ = 0;  ///< voxels per mm perpendicular to the plane
  std::vector<float> facing;  ///< share of a sheet's echo that is received, see sheetFacing()
};

/// All data that the trace of one frame reads; filled by the engine, shared by its tasks.
struct TraceInput {
  const FramePlan* plan = nullptr;
  const AcousticScene::Impl* scene = nullptr;
  ChannelConstants channels[TissueField::kStride];
  /// Share of the amplitude that passes at a vessel's edge, by pair of channels.
  float halfwayEdge[TissueField::kStride * TissueField::kStride]{};
  std::uint32_t gasChannels = 0, texturedChannels = 0;  ///< one bit per channel
  bool anyCt = false;
  const PlaneDisplacement* displacement = nullptr;  ///< null if nothing has moved
  const NeedleEchoes* needle = nullptr;             ///< null if there is no needle
  RayArrays lines, columns;                         ///< lines are padded to whole blocks
  RayArrays probeColumns;                           ///< probe frame
  PlaneAxes patientAxes, latticeAxes;
  std::vector<float> lineGap_mm, lineStrength;  ///< contact of each scanline
  std::vector<float> columnGap_mm;
  std::vector<float> contactDecay;                       ///< [gate or node row's gate]
  std::vector<float> elevation_mm;                       ///< [plane][gate]
  std::vector<float> scatterScale;                       ///< [plane][gate]
  RayArrays latticeLines;                                ///< scanlines in the scatterers' lattice
  TextureRays textureRays[TissueField::kStride][2];      ///< for textured channels, right and left of the midline
  float elevationX = 0, elevationY = 0, elevationZ = 0;  ///< unit, patient
  float latticeElevationX = 0, latticeElevationY = 0, latticeElevationZ = 0;
  std::uint32_t latticeSeed = 0;
  FloatMatrix nodeFromPatient;
  float nodeOffsetX = 0, nodeOffsetY = 0, nodeOffsetZ = 0;
};

inline constexpr std::int32_t kNoGasYet = -1, kNoGasEver = -2;

/// Result of tracing one block, before the beam.
struct BlockEchoes {
  alignas(64) std::int32_t gasGate[kBlockLines];  ///< first gate in gas behind tissue
  /// Scattering relative to the amplitude that reaches a gate, [component][gate][kBlockLines], component = 2 * look +
  /// (0 re, 1 im).
  AlignedArray<float> echo;
  /// Boundary echoes, the same for all looks, as seen along their own scanline, [gate][kBlockLines].
  AlignedArray<float> boundaries;
  /// Two-way amplitude in the middle of each gate in the central plane, without the needle's shadow,
  /// [gate][kBlockLines]; unused without a needle.
  AlignedArray<float> level;
};

/// Scratch memory of a thread for the trace.
struct TraceBuffers {
  /// Distances at one row of nodes, [channel][column], by plane and parity of the row.
  struct NodeRow {
    alignas(64) float distance[TissueField::kStride][kMaxColumns];
    alignas(64) float ct[kMaxColumns];
    alignas(64) float patch[kMaxColumns], wander_steps[kMaxColumns];
    alignas(64) float inside[kMaxColumns];  ///< 1 or 0
    /// Minimum and maximum of each channel's distances.
    alignas(64) float least[TissueField::kStride], most[TissueField::kStride];
  };
  /// Shift from the displayed position of tissue to its rest position, at one row of nodes, in the probe's plane, mm:
  /// at the row's columns, and expanded to scanlines. By parity of the row; unused if nothing has moved.
  struct ShiftRow {
    alignas(64) float columnX[kMaxColumns], columnZ[kMaxColumns], lineX[kBlockLines], lineZ[kBlockLines];
  };
  /// One row of grid cells, interpolated to the scanlines.
  struct CellRow {
    alignas(64) float sTop[kBlockLines], sBottom[kBlockLines];
    alignas(64) float cosine[kBlockLines], facing_dB[kBlockLines];
    /// Strength of boundaries, and the shift of their layers in steps of the profile, at the cell's upper and lower
    /// edges.
    alignas(64) float patchTop[kBlockLines], patchBottom[kBlockLines];
    alignas(64) float wanderTop_steps[kBlockLines], wanderBottom_steps[kBlockLines];
    alignas(64) float spread[kBlockLines];  ///< length over which a boundary's echo is spread, in gates
    alignas(64) float echoA[kBlockLines], echoB[kBlockLines], halfwayA[kBlockLines], halfwayB[kBlockLines];
    alignas(64) float impedanceA[kBlockLines], impedanceB[kBlockLines];
    alignas(64) float halfwayEdge[kBlockLines], inside[kBlockLines];
    alignas(64) std::int32_t channelA[kBlockLines], channelB[kBlockLines], profile[kBlockLines];
    std::uint32_t channelsPresent = 0;  ///< one bit per channel that occurs in a cell of the row
    bool nearBoundary = false;          ///< a cell is within reach of a boundary's layers or edge
  };
  /// State of each scanline during the trace downward.
  struct LineState {
    alignas(64) float amplitude[kBlockLines];  ///< two-way amplitude that remains of the beam; 0 beyond the volume
    alignas(64) float s[kBlockLines];
    alignas(64) float impedance[kBlockLines];
    alignas(64) std::int32_t channel[kBlockLines];  ///< -1 before the first gate
    alignas(64) std::int32_t pair[kBlockLines];
  };

  ShiftRow shift[2];
  NodeRow nodes[kMaxPlanes][2];
  CellRow cells[kMaxPlanes];
  LineState state[kMaxPlanes];
  alignas(64) float reaching[kBlockLines];  ///< amplitude before the next gate, averaged over the planes
  alignas(64) std::int32_t tissueSeen[kBlockLines];
};

struct TraceTimes_ms {
  double nodes = 0, gates = 0;
};

class ApertureTransmission;

/// Fills the constants of the scene's channels.
void setChannels(const AcousticScene::Impl& scene, TraceInput& input);

/// Traces the scanlines firstLine .. firstLine + kBlockLines - 1. Computes their echoes on all gates, before the beam,
/// and the share of the amplitude that each gate passes.
void traceBlock(const TraceInput& input, int firstLine, TraceBuffers& buffers, BlockEchoes& echoes,
                ApertureTransmission& transmission, TraceTimes_ms& times);

}  // namespace insonate::cpu
