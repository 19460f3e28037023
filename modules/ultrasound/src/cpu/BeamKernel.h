#pragma once

#include "cpu/TraceInput.h"
#include "model/FramePlan.h"

#include <vector>

namespace insonate::cpu {

/// The plan's kernels as floats, with the interpolation from gates to samples.
struct BeamTables {
  std::vector<float> axialKernel;    ///< [gate][maxAxialRadius + 1], center first
  std::vector<float> lateralKernel;  ///< [gate][maxLateralRadius + 1]
  struct Upsample {
    int gateBefore;  ///< index of the preceding gate, relative to sample / stride
    float weight[4];
  };
  std::vector<Upsample> upsample;  ///< [sample % stride]

  BeamTables() = default;
  explicit BeamTables(const FramePlan& plan);
};

/// Echoes after the axial kernel: [component][gate][width]. The scanlines are preceded and followed by maxLateralRadius
/// zeros (rounded up), so that the lateral kernel needs no special case at the edges.
struct EchoPlane {
  int width = 0, margin = 0;
  AlignedArray<float> values;
  float* row(const FramePlan& plan, int component, int gate) const {
    return values.get() + (std::size_t(component) * plan.gates + gate) * width;
  }
};

/// Applies the axial kernel to one block's echoes.
void convolveAxially(const FramePlan& plan, const BeamTables& tables, const float* blockEcho, int firstLine,
                     EchoPlane& out);

/// Rows that a thread needs for the lateral convolution: a ring buffer of four gates.
struct LateralBuffers {
  AlignedArray<float> ring;  ///< [component][gate & 3][width]
};

/// Applies the lateral kernel and computes the magnitude for samples firstSample .. endSample - 1. `envelope` is
/// [look][sample][scanline].
void convolveLaterally(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int firstSample,
                       int endSample, LateralBuffers& buffers, float* envelope);

}  // namespace insonate::cpu
