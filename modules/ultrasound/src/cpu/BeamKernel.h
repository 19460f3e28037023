#pragma once

#include "cpu/TraceInput.h"
#include "model/FramePlan.h"

#include <vector>

namespace insonate::cpu {

/// The plan's kernels as floats, and the interpolation from gates to samples.
struct BeamTables {
  std::vector<float> axialKernel;    ///< [gate][maxAxialRadius + 1], center first
  std::vector<float> lateralKernel;  ///< [gate][maxLateralRadius + 1]
  struct Upsample {
    int gateBefore;  ///< relative to sample / stride
    float weight[4];
  };
  std::vector<Upsample> upsample;  ///< [sample % stride]

  BeamTables() = default;
  explicit BeamTables(const FramePlan& plan);
};

/// Echoes after the axial kernel: [component][gate][width], scanlines preceded and followed by maxLateralRadius zeros
/// (rounded up), so that the lateral kernel runs without edges.
struct EchoPlane {
  int width = 0, margin = 0;
  AlignedArray<float> values;
  float* row(const FramePlan& plan, int component, int gate) const {
    return values.get() + (std::size_t(component) * plan.gates + gate) * width;
  }
};

/// Axial kernel over one block's echoes.
void convolveAxially(const FramePlan& plan, const BeamTables& tables, const float* blockEcho, int firstLine,
                     EchoPlane& out);

/// Rows a thread needs for convolving laterally: a ring of four gates.
struct LateralBuffers {
  AlignedArray<float> ring;  ///< [component][gate & 3][width]
};

/// Lateral kernel and magnitude for samples firstSample .. endSample - 1. `envelope` is [look][sample][scanline].
void convolveLaterally(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int firstSample,
                       int endSample, LateralBuffers& buffers, float* envelope);

}  // namespace insonate::cpu
