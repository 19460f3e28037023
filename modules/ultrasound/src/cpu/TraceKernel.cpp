// Compiled once for every instruction set (see foreach_target.h); traceBlock() selects one at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/TraceKernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "cpu/Cells-inl.h"
#include "cpu/Gates-inl.h"
#include "cpu/Nodes-inl.h"
#include "cpu/Shifts-inl.h"
#include "cpu/TraceInput.h"

#include <hwy/highway.h>

#include <chrono>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {

template <int kLooks>
void traceLooks(const TraceInput& in, int firstLine, TraceBuffers& b, BlockEchoes& e,
                ApertureTransmission& transmission, TraceTimes_ms& times) {
  const FramePlan& plan = *in.plan;
  const int planes = plan.settings.elevationPlanes;
  using Clock = std::chrono::steady_clock;
  startLines(in, firstLine, b, e, transmission);
  const auto makeNodes = [&](int row) {
    TraceBuffers::ShiftRow& shifts = b.shift[row & 1];
    if (in.displacement) computeShiftRow(in, firstLine, row, shifts);
    for (int p = 0; p < planes; ++p) computeNodeRow(in, firstLine, p, row, shifts, b.nodes[p][row & 1]);
  };
  makeNodes(0);
  for (int row = 0; row + 1 < plan.nodeRows; ++row) {
    const auto start = Clock::now();
    makeNodes(row + 1);
    for (int p = 0; p < planes; ++p) computeCellRow(in, firstLine, p, row, b);
    const auto middle = Clock::now();
    const int end = std::min(plan.gates, (row + 1) * plan.cellGates);
    for (int gate = row * plan.cellGates; gate < end; ++gate)
      traceGate<kLooks>(in, firstLine, row, gate, b, e, transmission.passed(gate, firstLine));
    times.nodes += std::chrono::duration<double, std::milli>(middle - start).count();
    times.gates += std::chrono::duration<double, std::milli>(Clock::now() - middle).count();
  }
}

void traceBlockTarget(const TraceInput& in, int firstLine, TraceBuffers& b, BlockEchoes& e,
                      ApertureTransmission& transmission, TraceTimes_ms& times) {
  switch (in.plan->settings.looks) {
    case 1:
      return traceLooks<1>(in, firstLine, b, e, transmission, times);
    case 2:
      return traceLooks<2>(in, firstLine, b, e, transmission, times);
    default:
      return traceLooks<3>(in, firstLine, b, e, transmission, times);
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::cpu {
HWY_EXPORT(traceBlockTarget);
void traceBlock(const TraceInput& input, int firstLine, TraceBuffers& buffers, BlockEchoes& echoes,
                ApertureTransmission& transmission, TraceTimes_ms& times) {
  HWY_DYNAMIC_DISPATCH(traceBlockTarget)(input, firstLine, buffers, echoes, transmission, times);
}
}  // namespace insonate::cpu
#endif
