#include "InterfaceSmoothing.h"

#include "RowKernels.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace insonate::display {
namespace {

constexpr int kBlocksPerTask = 24;

template <class Body>
void overBlocks(int blocks, const Body& body) {
  using Range = tbb::blocked_range<int>;
  tbb::parallel_for(Range(0, blocks, kBlocksPerTask), [&](const Range& range) {
    for (int b = range.begin(); b < range.end(); ++b) body(b);
  });
}

}  // namespace

InterfaceSmoothing::InterfaceSmoothing(const DisplayPlan& plan, double strength)
    : blocks_(plan.blocks),
      columns_(plan.scanlines),
      strength_(static_cast<float>(strength)),
      mean_(static_cast<int>(blocks_.size()), columns_),
      xx_(mean_.rows(), columns_),
      xz_(mean_.rows(), columns_),
      zz_(mean_.rows(), columns_),
      structure_(mean_.rows(), columns_),
      edge_(mean_.rows(), columns_),
      slope_(mean_.rows(), columns_) {}

void InterfaceSmoothing::analyse(const Plane& blockLevels) {
  overBlocks(mean_.rows(), [&](int b) { smoothMean(blockLevels, b); });
  overBlocks(mean_.rows(), [&](int b) { findGradients(b); });
  overBlocks(mean_.rows(), [&](int b) { findInterface(b); });
}

void InterfaceSmoothing::smoothMean(const Plane& blockLevels, int b) {
  meanRow(blockLevels.row(b - 1), blockLevels.row(b), blockLevels.row(b + 1), blocks_[b].edgeStride, columns_,
          mean_.row(b));
  mean_.extendRow(b);
}

void InterfaceSmoothing::findGradients(int b) {
  tensorRow({.above = mean_.row(b - 1),
             .here = mean_.row(b),
             .below = mean_.row(b + 1),
             .stride = blocks_[b].edgeStride,
             .lateral = blocks_[b].edgeLateral,
             .axial = blocks_[b].edgeAxial,
             .columns = columns_,
             .xx = xx_.row(b),
             .xz = xz_.row(b),
             .zz = zz_.row(b)});
  for (Plane* plane : {&xx_, &xz_, &zz_}) plane->extendRow(b);
}

void InterfaceSmoothing::findInterface(int b) {
  OrientRow task{.stride = blocks_[b].edgeStride,
                 .from = kEdgeFrom,
                 .to = kEdgeTo,
                 .maxSlope = kMaxSlope,
                 .columns = columns_,
                 .structure = structure_.row(b),
                 .edge = edge_.row(b),
                 .slope = slope_.row(b)};
  for (int o = 0; o < 5; ++o) {
    task.xx[o] = xx_.row(b + o - 2);
    task.xz[o] = xz_.row(b + o - 2);
    task.zz[o] = zz_.row(b + o - 2);
  }
  orientRow(task);
}

void InterfaceSmoothing::smooth(const DisplayPlan& plan, const Plane& levels, int row, float* out) const {
  const auto [before, after, mix] = plan.between(row);
  const Block& block = blocks_[std::min(row / plan.blockRows, mean_.rows() - 1)];
  SmoothRow task{.origin = levels.row(0),
                 .rowStride = levels.stride(),
                 .rows = levels.rows(),
                 .row = row,
                 .slope = slope_.row(row / plan.blockRows),
                 .rowsPerSlope = block.rowsPerSlope,
                 .structureBefore = structure_.row(before),
                 .structureAfter = structure_.row(after),
                 .edgeBefore = edge_.row(before),
                 .edgeAfter = edge_.row(after),
                 .meanBefore = mean_.row(before),
                 .meanAfter = mean_.row(after),
                 .mix = mix,
                 .contrast = kContrast,
                 .contrastBend = kContrastBend,
                 .contrastReach = kContrastReach_dB,
                 .strength = strength_,
                 .margin = Plane::kMargin,
                 .columns = Plane::padded(columns_),
                 .out = out};
  for (int t = 0; t < 5; ++t) task.axial[t] = levels.row(row + (t - 2) * plan.axialStride);
  std::copy_n(plan.axialWeight, 3, task.axialWeight);
  task.plainStride = block.plainStride, task.alongStride = block.alongStride;
  std::copy_n(block.plainWeight, 3, task.plainWeight);
  std::copy_n(block.alongWeight, 4, task.alongWeight);
  smoothRow(task);
}

}  // namespace insonate::display
