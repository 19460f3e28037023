#pragma once

#include "model/Contact.h"
#include "thesis/ThesisModel.h"

#include <hwy/aligned_allocator.h>

#include <vector>

namespace insonate::thesis {

/// Number of scanlines in a block, the part of a frame that one task traces: a multiple of every SIMD vector length up
/// to 16 lanes.
inline constexpr int kBlockLines = 32;
/// Maximum number of node columns in a block, rounded up to whole SIMD vectors.
inline constexpr int kMaxColumns = kBlockLines + 16;
inline constexpr int kMaxPlanes = 9;

using AlignedFloats = hwy::AlignedFreeUniquePtr<float[]>;

/// A scanline or node column.
struct Ray {
  Vec3 origin_mm, direction;
};

/// All data that the tasks of one frame read.
struct KernelInput {
  const FramePlan* plan = nullptr;
  const ThesisPlan* thesis = nullptr;
  const AcousticScene::Impl* scene = nullptr;
  std::array<ChannelAcoustics, TissueField::kStride> channels;
  std::vector<Ray> columns, probeColumns;           ///< node columns in the patient frame and in the probe frame
  const PlaneDisplacement* displacement = nullptr;  ///< displacement of the tissue; null if no tissue is displaced
  Mat3 patientFromProbe;                            ///< rotation that converts shifts to the patient frame
  std::vector<float> columnGap_mm;
  /// Change of each scanline's level by its contact with the skin; padded to whole blocks.
  std::vector<float> lineLevel_dB;
  std::vector<float> contactDecay;  ///< share of the skin's shift that remains at the depth of each node row
  std::vector<float> elevation_mm;  ///< offset of each elevation plane from the central plane, [plane][node row]
  Vec3 elevationAxis;
  std::uint32_t noiseSeed = 0;
};

/// Scratch memory of a thread.
struct KernelBuffers {
  /// Signed distances and CT deviation at one row of nodes.
  struct NodeRow {
    alignas(64) float distance_mm[TissueField::kStride][kMaxColumns];
    alignas(64) float ct_HU[kMaxColumns];
    alignas(64) float beyond[kMaxColumns];
  };
  /// Acoustic values of the medium and of boundaries at one map row, which lies on a row of nodes or midway between
  /// two: one value per node column or, after expansion, per scanline.
  struct MapRow {
    alignas(64) float reflection[kMaxColumns], loss_dBpmm[kMaxColumns], echo[kMaxColumns];
  };
  /// Contribution of one row of the noise's lattice to one octave, for each scanline: at the signed distance dy (in
  /// cells) below this row the contribution is constant + perCell * dy.
  struct NoiseRow {
    alignas(64) float constant[kBlockLines], perCell[kBlockLines];
  };
  NodeRow nodes[kMaxPlanes][3];  ///< ring buffer of node rows for each plane
  Vec3 shifts[3][kMaxColumns];   ///< displacement of the tissue at the same rows, in the patient frame
  MapRow columns;
  MapRow lines[kMaxPlanes][2];  ///< last two map rows of each plane; second index: 0 for even, 1 for odd rows
  alignas(64) float level_dB[kMaxPlanes][kBlockLines];
  NoiseRow noise[kNoiseOctaves][2];
  int noiseCell[kNoiseOctaves];  ///< for each octave o, the row of the noise's lattice to which noise[o][0] belongs
  alignas(64) float tail[kBlockLines];
};

/// Echoes before the lateral blur along the face: [gate][width]. The scanlines are preceded and followed by copies of
/// the outermost scanlines.
struct EchoRows {
  int width = 0, margin = 0;
  AlignedFloats values;
  float* row(int gate) const { return values.get() + std::size_t(gate) * width; }
};

struct KernelTimes_ms {
  double map = 0, trace = 0, blur = 0;
};

/// Traces the scanlines firstLine .. firstLine + kBlockLines - 1 on all gates.
void traceBlock(const KernelInput& input, int firstLine, KernelBuffers& buffers, const EchoRows& echo,
                KernelTimes_ms& times);

/// Applies the lateral blur along the face and computes the envelope of samples firstSample .. endSample - 1. `ring`
/// has room for two rows; `envelope` is [sample][scanline].
void blurSamples(const FramePlan& plan, const std::vector<float>& lateralKernel, const EchoRows& echo, int firstSample,
                 int endSample, float* ring, float* envelope);

}  // namespace insonate::thesis
