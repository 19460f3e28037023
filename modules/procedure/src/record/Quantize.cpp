#include <insonate/procedure/AttemptSample.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

/// Index of each value in QuantizedSample::channel. A tool has seven: the omitted component of its quaternion (0: the
/// tool is not held), the other three, the position.
enum Channel {
  kProbe = 0,
  kNeedle = 7,
  kTipDepth = 14,
  kForce,
  kDepth,
  kAspirating,
  kToArtery,
  kToLung,
  kToVeinCenter,
  kTenting,
  kWire,
  kDilator,
  kCatheter,
  kWireToHeart,
  kCatheterToHeart
};
static_assert(kCatheterToHeart + 1 == QuantizedSample::kChannels);

constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();
constexpr double kMaxSteps = 2e9;

std::int32_t stepsOf(double value, double quantum) {
  if (!std::isfinite(value)) return 0;
  return static_cast<std::int32_t>(std::lround(std::clamp(value / quantum, -kMaxSteps, kMaxSteps)));
}

std::int32_t stepsOf(const std::optional<double>& value, double quantum) {
  return value && std::isfinite(*value) ? stepsOf(*value, quantum) : kUnknown;
}

std::optional<double> valueOf(std::int32_t steps, double quantum) {
  if (steps == kUnknown) return std::nullopt;
  return steps * quantum;
}

/// Channels that older recordings do not have are read as 0, which therefore means an empty value: 1 stands for 0 mm,
/// and 0 is left out.
std::int32_t offsetSteps(const std::optional<double>& value_mm) {
  if (!value_mm || !std::isfinite(*value_mm)) return 0;
  const std::int32_t steps = stepsOf(*value_mm, kDistanceQuantum_mm);
  return steps < 0 ? steps : steps + 1;
}

std::optional<double> offsetValue(std::int32_t steps) {
  if (steps == 0) return std::nullopt;
  return (steps < 0 ? steps : steps - 1) * kDistanceQuantum_mm;
}

bool isPlace(const Transform& pose) {
  for (const Vec3& column : pose.linear.column)
    if (!isFinite(column)) return false;
  const Vec3 o = pose.offset;
  return isFinite(o) && std::max({std::abs(o.x), std::abs(o.y), std::abs(o.z)}) <= kFarthest_mm;
}

/// The three smaller components; the largest follows from the unit length and is positive by convention.
void putTool(const std::optional<Transform>& tool, std::int32_t* channel) {
  if (!tool || !isPlace(*tool)) return;
  Eigen::Matrix3d rotation;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) rotation(r, c) = tool->linear.column[c][r];
  Eigen::Vector4d q = Eigen::Quaterniond(rotation).normalized().coeffs();
  if (!q.allFinite()) return;
  int largest = 0;
  q.cwiseAbs().maxCoeff(&largest);
  if (q[largest] < 0) q = -q;
  *channel++ = largest + 1;
  for (int i = 0; i < 4; ++i)
    if (i != largest) *channel++ = stepsOf(q[i], kRotationQuantum);
  for (int axis = 0; axis < 3; ++axis) *channel++ = stepsOf(tool->offset[axis], kPositionQuantum_mm);
}

std::optional<Transform> toolOf(const std::int32_t* channel) {
  const int largest = *channel++ - 1;
  if (largest < 0 || largest > 3) return std::nullopt;
  Eigen::Vector4d q = Eigen::Vector4d::Zero();
  for (int i = 0; i < 4; ++i)
    if (i != largest) q[i] = *channel++ * kRotationQuantum;
  q[largest] = std::sqrt(std::max(0.0, 1 - (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3])));
  const Eigen::Matrix3d rotation = Eigen::Quaterniond(q).toRotationMatrix();
  Transform tool;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) tool.linear.column[c][r] = rotation(r, c);
  for (int axis = 0; axis < 3; ++axis) tool.offset[axis] = *channel++ * kPositionQuantum_mm;
  return tool;
}

}  // namespace

QuantizedSample quantize(const AttemptSample& sample) noexcept {
  QuantizedSample steps;
  steps.time_us = sample.time_us;
  auto& channel = steps.channel;
  putTool(sample.patientFromProbe, &channel[kProbe]);
  putTool(sample.patientFromNeedle, &channel[kNeedle]);
  channel[kTipDepth] = stepsOf(sample.needleDepth_mm, kDistanceQuantum_mm);
  channel[kForce] = stepsOf(sample.probeForce_N, kForceQuantum_N);
  channel[kDepth] = stepsOf(sample.imageDepth_mm, kDistanceQuantum_mm);
  channel[kAspirating] = sample.aspirating;
  channel[kToArtery] = stepsOf(sample.toArtery_mm, kDistanceQuantum_mm);
  channel[kToLung] = stepsOf(sample.toLung_mm, kDistanceQuantum_mm);
  channel[kToVeinCenter] = stepsOf(sample.toVeinCenter_mm, kDistanceQuantum_mm);
  channel[kTenting] = stepsOf(sample.tenting_mm, kDistanceQuantum_mm);
  channel[kWire] = offsetSteps(sample.wire_mm), channel[kDilator] = offsetSteps(sample.dilator_mm);
  channel[kCatheter] = offsetSteps(sample.catheter_mm);
  channel[kWireToHeart] = offsetSteps(sample.wireToHeart_mm);
  channel[kCatheterToHeart] = offsetSteps(sample.catheterToHeart_mm);
  return steps;
}

AttemptSample dequantize(const QuantizedSample& steps) noexcept {
  const auto& channel = steps.channel;
  AttemptSample sample;
  sample.time_us = steps.time_us;
  sample.patientFromProbe = toolOf(&channel[kProbe]);
  sample.patientFromNeedle = toolOf(&channel[kNeedle]);
  sample.needleDepth_mm = valueOf(channel[kTipDepth], kDistanceQuantum_mm);
  sample.probeForce_N = channel[kForce] * kForceQuantum_N;
  sample.imageDepth_mm = channel[kDepth] * kDistanceQuantum_mm;
  sample.aspirating = channel[kAspirating] != 0;
  sample.toArtery_mm = valueOf(channel[kToArtery], kDistanceQuantum_mm);
  sample.toLung_mm = valueOf(channel[kToLung], kDistanceQuantum_mm);
  sample.toVeinCenter_mm = valueOf(channel[kToVeinCenter], kDistanceQuantum_mm);
  sample.tenting_mm = channel[kTenting] * kDistanceQuantum_mm;
  sample.wire_mm = offsetValue(channel[kWire]), sample.dilator_mm = offsetValue(channel[kDilator]);
  sample.catheter_mm = offsetValue(channel[kCatheter]);
  sample.wireToHeart_mm = offsetValue(channel[kWireToHeart]);
  sample.catheterToHeart_mm = offsetValue(channel[kCatheterToHeart]);
  return sample;
}

}  // namespace insonate
