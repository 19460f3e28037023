#pragma once

#include "model/Contact.h"
#include "thesis/ThesisModel.h"

#include <hwy/aligned_allocator.h>

#include <vector>

namespace insonate::thesis {

/// Scanlines are traced in blocks of this many, one task a block; a multiple of every vector length up to 16 lanes.
inline constexpr int kBlockLines = 32;
inline constexpr int kMaxColumns = kBlockLines + 16;  ///< node columns of a block, with room for a vector's tail
inline constexpr int kMaxPlanes = 9;

using AlignedFloats = hwy::AlignedFreeUniquePtr<float[]>;

/// A scanline.
struct Ray {
  Vec3 origin_mm, direction;
};

/// All that the tasks of one frame read.
struct KernelInput {
  const FramePlan* plan = nullptr;
  const ThesisPlan* thesis = nullptr;
  const AcousticScene::Impl* scene = nullptr;
  std::array<ChannelAcoustics, TissueField::kStride> channels;
  std::vector<Ray> columns, probeColumns;           ///< in the patient, in the probe frame
  const PlaneDisplacement* displacement = nullptr;  ///< null where nothing has moved
  Mat3 patientFromProbe;                            ///< turns shifts
  std::vector<float> columnGap_mm;
  std::vector<float> lineLevel_dB;  ///< contact; padded to whole blocks
  std::vector<float> contactDecay;  ///< [node row]
  std::vector<float> elevation_mm;  ///< [plane][node row]
  Vec3 elevationAxis;
  std::uint32_t noiseSeed = 0;
};

/// Per-thread scratch.
struct KernelBuffers {
  /// The scene at one row of nodes.
  struct NodeRow {
    alignas(64) float distance_mm[TissueField::kStride][kMaxColumns];
    alignas(64) float ct_HU[kMaxColumns];
    alignas(64) float beyond[kMaxColumns];
  };
  /// Medium and boundaries at one map row, at columns and spread to scanlines.
  struct MapRow {
    alignas(64) float reflection[kMaxColumns], loss_dBpmm[kMaxColumns], echo[kMaxColumns];
  };
  /// One octave of noise between two rows of its lattice: with the row's distance dy, each line's value is
  /// constant + perCell * dy.
  struct NoiseRow {
    alignas(64) float constant[kBlockLines], perCell[kBlockLines];
  };
  NodeRow nodes[kMaxPlanes][3];  ///< ring over rows
  Vec3 shifts[3][kMaxColumns];   ///< the same ring
  MapRow columns;
  MapRow lines[kMaxPlanes][2];  ///< by parity of the row
  alignas(64) float level_dB[kMaxPlanes][kBlockLines];
  NoiseRow noise[kNoiseOctaves][2];
  int noiseCell[kNoiseOctaves];  ///< lattice row of noise[o][0]
  alignas(64) float tail[kBlockLines];
};

/// Echoes before the tangential blur: [gate][width], scanlines preceded and followed by copies of the outermost ones.
struct EchoRows {
  int width = 0, margin = 0;
  AlignedFloats values;
  float* row(int gate) const { return values.get() + std::size_t(gate) * width; }
};

struct KernelTimes_ms {
  double map = 0, trace = 0, blur = 0;
};

/// The scanlines firstLine .. firstLine + kBlockLines - 1 on all gates.
void traceBlock(const KernelInput& input, int firstLine, KernelBuffers& buffers, const EchoRows& echo,
                KernelTimes_ms& times);

/// Tangential blur and samples firstSample .. endSample - 1; `ring` has room for two rows, `envelope` is
/// [sample][scanline].
void blurSamples(const FramePlan& plan, const std::vector<float>& lateralKernel, const EchoRows& echo, int firstSample,
                 int endSample, float* ring, float* envelope);

}  // namespace insonate::thesis
