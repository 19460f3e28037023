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

/// Number of scanlines in a block, the part of a frame that one task traces: a multiple of every SIMD vector length up
/// to 16 lanes.
inline constexpr int kBlockLines = 32;
/// Maximum number of node columns in a block, rounded up to whole SIMD vectors.
inline constexpr int kMaxColumns = kBlockLines + 16;
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

/// Unit vectors of the probe's lateral and axial axes in another frame (per mm of the probe frame), for converting a
/// shift in the imaging plane to that frame.
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
  float halfway = 1;  ///< share of the two-way amplitude that remains after half a gate
  float echo_dB = 0, ctEcho_dBperHU = 0;
  float impedance = 0, ctImpedancePerHU = 0;
  float textureStrength_dB = 0;
  bool sheets = false;
  const AcousticTissue* tissue = nullptr;
  const TextureTile* tile = nullptr;
};

/// Origins (x, y, z) and directions (dx, dy, dz) of scanlines or node columns, one array per coordinate.
struct RayArrays {
  std::vector<float> x, y, z, dx, dy, dz;
  void resize(std::size_t n) {
    for (auto* a : {&x, &y, &z, &dx, &dy, &dz}) a->resize(n);
  }
};

/// The scanlines in coordinates of a texture tile, in voxels, shifted by minus half a voxel, so that rounding to the
/// nearest whole number gives the voxel.
struct TextureRays {
  RayArrays line;
  PlaneAxes axes;  ///< change of the voxel position per mm along the probe's lateral and axial axes
  /// Change of the voxel position per mm perpendicular to the imaging plane.
  float elevationX = 0, elevationY = 0, elevationZ = 0;
  std::vector<float> facing;  ///< share of a sheet's echo that is received, see sheetFacing()
};

/// All data that the trace of one frame reads; filled by the engine, shared by its tasks.
struct TraceInput {
  const FramePlan* plan = nullptr;
  const AcousticScene::Impl* scene = nullptr;
  ChannelConstants channels[TissueField::kStride];
  /// Share of the two-way amplitude that remains, per half gate, at the edge of a vessel, by pair of channels.
  float halfwayEdge[TissueField::kStride * TissueField::kStride]{};
  /// One bit for each channel that is gas, and for each channel with a texture.
  std::uint32_t gasChannels = 0, texturedChannels = 0;
  bool anyCt = false;
  const PlaneDisplacement* displacement = nullptr;  ///< displacement of the tissue; null if no tissue is displaced
  const NeedleEchoes* needle = nullptr;             ///< echoes and shadow of the needle; null if there is no needle
  RayArrays lines, columns;  ///< scanlines, padded to whole blocks, and node columns, in the patient frame
  RayArrays probeColumns;    ///< node columns in the probe frame
  PlaneAxes patientAxes, latticeAxes;
  std::vector<float> lineGap_mm, lineStrength;  ///< Contact::gap_mm and Contact::strength of each scanline
  std::vector<float> columnGap_mm;
  std::vector<float> contactDecay;  ///< share of the skin's shift that remains at each depth, [node row], then [gate]
  std::vector<float> elevation_mm;  ///< offset of each elevation plane from the central plane, [plane][gate]
  std::vector<float> scatterScale;  ///< factor on the amplitude of scatterers in each elevation plane, [plane][gate]
  RayArrays latticeLines;           ///< scanlines in the scatterers' lattice
  /// Scanlines in the tiles of textured channels, right and left of the midline.
  TextureRays textureRays[TissueField::kStride][2];
  float elevationX = 0, elevationY = 0, elevationZ = 0;  ///< unit vector of the elevation direction, patient frame
  float latticeElevationX = 0, latticeElevationY = 0, latticeElevationZ = 0;
  std::uint32_t latticeSeed = 0;
  FloatMatrix nodeFromPatient;
  float nodeOffsetX = 0, nodeOffsetY = 0, nodeOffsetZ = 0;
};

inline constexpr std::int32_t kNoGasYet = -1, kNoGasEver = -2;

/// Echoes of one block of scanlines, before convolution with the beam's point-spread function.
struct BlockEchoes {
  alignas(64) std::int32_t gasGate[kBlockLines];  ///< first gate in gas behind tissue; kNoGasYet: none found so far;
                                                  ///< kNoGasEver: none can be found
  /// Scattering relative to the amplitude that reaches the gate, [component][gate][kBlockLines], component = 2 * look +
  /// (0 for the real, 1 for the imaginary part).
  AlignedArray<float> echo;
  /// Echoes of boundaries, the same for all looks, as received on their own scanline, [gate][kBlockLines].
  AlignedArray<float> boundaries;
  /// Two-way amplitude in the middle of each gate in the central plane, without the needle's shadow,
  /// [gate][kBlockLines]; unused without a needle.
  AlignedArray<float> level;
};

/// Scratch memory of a thread for the trace.
struct TraceBuffers {
  /// Signed distances at one row of lattice nodes, [channel][column]. One buffer for each plane and for even and odd
  /// rows.
  struct NodeRow {
    alignas(64) float distance[TissueField::kStride][kMaxColumns];
    alignas(64) float ct[kMaxColumns];
    alignas(64) float patch[kMaxColumns], wander_steps[kMaxColumns];
    alignas(64) float inside[kMaxColumns];  ///< 1 if the node lies in the volume, else 0
    /// Minimum (least) and maximum (most) of each channel's distances in the row.
    alignas(64) float least[TissueField::kStride], most[TissueField::kStride];
  };
  /// Displacement from the displayed position of tissue to its rest position, at one row of lattice nodes, in the
  /// probe's plane, mm: at the row's columns, and expanded to scanlines. One buffer each for even and odd rows; unused
  /// if no tissue is displaced.
  struct ShiftRow {
    alignas(64) float columnX[kMaxColumns], columnZ[kMaxColumns], lineX[kBlockLines], lineZ[kBlockLines];
  };
  /// Values of one row of lattice cells, expanded to the scanlines.
  struct CellRow {
    alignas(64) float sTop[kBlockLines], sBottom[kBlockLines];
    alignas(64) float cosine[kBlockLines], facing_dB[kBlockLines];
    /// Values at the cell's upper and lower edges: patch: random strength of boundaries, SD 1; wander: shift of the
    /// boundary's layers, in steps of the boundary profile.
    alignas(64) float patchTop[kBlockLines], patchBottom[kBlockLines];
    alignas(64) float wanderTop_steps[kBlockLines], wanderBottom_steps[kBlockLines];
    /// Length along the scanline over which a boundary's echo is spread, in gates.
    alignas(64) float spread[kBlockLines];
    alignas(64) float echoA[kBlockLines], echoB[kBlockLines], halfwayA[kBlockLines], halfwayB[kBlockLines];
    alignas(64) float impedanceA[kBlockLines], impedanceB[kBlockLines];
    alignas(64) float halfwayEdge[kBlockLines], inside[kBlockLines];
    alignas(64) std::int32_t channelA[kBlockLines], channelB[kBlockLines], profile[kBlockLines];
    std::uint32_t channelsPresent = 0;  ///< one bit per channel that occurs in a cell of the row
    /// True if a cell is so close to a boundary that the boundary's layers or edge shadow affect it.
    bool nearBoundary = false;
  };
  /// State of each scanline while it is traced downward, gate by gate.
  struct LineState {
    alignas(64) float amplitude[kBlockLines];  ///< two-way amplitude that remains of the beam; 0 beyond the volume
    alignas(64) float s[kBlockLines];
    alignas(64) float impedance[kBlockLines];
    alignas(64) std::int32_t channel[kBlockLines];  ///< channel at the last gate; -1 before the first gate
    alignas(64) std::int32_t pair[kBlockLines];
  };

  ShiftRow shift[2];
  NodeRow nodes[kMaxPlanes][2];
  CellRow cells[kMaxPlanes];
  LineState state[kMaxPlanes];
  alignas(64) float reaching[kBlockLines];  ///< two-way amplitude that reaches the next gate, averaged over the
                                            ///< elevation planes
  alignas(64) std::int32_t tissueSeen[kBlockLines];
};

struct TraceTimes_ms {
  double nodes = 0, gates = 0;
};

class ApertureTransmission;

/// Fills the acoustic constants of the scene's channels (structures) in `input`.
void setChannels(const AcousticScene::Impl& scene, TraceInput& input);

/// Traces the scanlines firstLine .. firstLine + kBlockLines - 1: computes their echoes on all gates, before
/// convolution with the point-spread function, and the share of the amplitude that each gate passes.
void traceBlock(const TraceInput& input, int firstLine, TraceBuffers& buffers, BlockEchoes& echoes,
                ApertureTransmission& transmission, TraceTimes_ms& times);

}  // namespace insonate::cpu
