#pragma once

#include "cpu/TraceInput.h"
#include "model/FramePlan.h"

#include <vector>

namespace insonate::cpu {

/// Tables of a frame plan as floats: the kernels of the point-spread function, and the weights for interpolation from
/// gates (points of a scanline at which echoes are computed) to samples.
struct BeamTables {
  std::vector<float> axialKernel;    ///< half of each gate's axial kernel, [gate][maxAxialRadius + 1], center first
  std::vector<float> lateralKernel;  ///< half of each gate's lateral kernel, [gate][maxLateralRadius + 1], center first
  struct Upsample {
    int gateBefore;  ///< number of the gate before the sample, counted from gate number sample / stride
    float weight[4];
  };
  std::vector<Upsample> upsample;  ///< interpolation weights, index [sample % stride]

  BeamTables() = default;
  explicit BeamTables(const FramePlan& plan);
};

/// Echoes of all scanlines after convolution with the axial kernel: [component][gate][width]. The scanlines are
/// preceded and followed by maxLateralRadius zeros (rounded up), so that the lateral kernel needs no special case at
/// the edges.
struct EchoPlane {
  int width = 0, margin = 0;
  AlignedArray<float> values;
  float* row(const FramePlan& plan, int component, int gate) const {
    return values.get() + (std::size_t(component) * plan.gates + gate) * width;
  }
};

/// Convolves the echoes of one block of scanlines with the axial kernel.
void convolveAxially(const FramePlan& plan, const BeamTables& tables, const float* blockEcho, int firstLine,
                     EchoPlane& out);

/// Memory of one thread for the lateral convolution: a ring buffer of the rows of four gates.
struct LateralBuffers {
  AlignedArray<float> ring;  ///< rows of the last four gates, [component][gate & 3][width]
};

/// Convolves the echoes with the lateral kernel and computes the envelope's magnitude for samples firstSample ..
/// endSample - 1. `envelope` is [look][sample][scanline].
void convolveLaterally(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int firstSample,
                       int endSample, LateralBuffers& buffers, float* envelope);

}  // namespace insonate::cpu
