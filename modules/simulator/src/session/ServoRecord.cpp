#include "hand/SkinSurface.h"

#include <insonate/simulator/ServoRecord.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <optional>

namespace insonate {
namespace {

/// A grid stores distances up to 300 mm; a structure at this distance does not exist.
constexpr float kFar_mm = 200;

constexpr int wallIndex(Label wall) {
  return static_cast<int>(std::ranges::find(kNeedleWalls, wall) - kNeedleWalls.begin());
}

std::optional<double> distance(const TissueSample& tissue, Label wall) {
  const float distance_mm = tissue.distance_mm[wallIndex(wall)];
  if (distance_mm > kFar_mm) return std::nullopt;
  return distance_mm;
}

constexpr AttemptEventKind kindOf(NeedleEventKind kind) {
  switch (kind) {
    case NeedleEventKind::Entered:
      return AttemptEventKind::Entered;
    case NeedleEventKind::Left:
      return AttemptEventKind::Left;
    case NeedleEventKind::Withdrawn:
      return AttemptEventKind::Withdrawn;
    case NeedleEventKind::Struck:
      break;
  }
  return AttemptEventKind::Struck;
}

/// The hole in the skin. The skin bends far before the puncture: the tip is then deeper by this amount.
std::optional<Vec3> holeOf(const NeedleEvent& event, const SkinSurface& skin) {
  constexpr double kMost_mm = 20;
  return skin.along(event.tip_mm, -event.axis, kMost_mm);
}

}  // namespace

AttemptSample makeSample(const ServoOutput& output, const TickContext& context, const TissueGrid* grid,
                         std::span<const CenterLine> veins, const VesselLocator& vessels) noexcept {
  AttemptSample sample;
  sample.time_us = context.time_us;
  if (context.present[kProbeTool]) sample.patientFromProbe = output.tools[kProbeTool].patientFromTool;
  sample.probeForce_N = output.skinForce_N;
  sample.imageDepth_mm = context.imageDepth_mm;
  sample.aspirating = context.aspirating;
  if (!context.present[kNeedleTool]) return sample;
  sample.patientFromNeedle = output.tools[kNeedleTool].patientFromTool;
  if (output.needle.inBody) sample.needleDepth_mm = output.needle.depth_mm;
  if (output.needle.tenting) sample.tenting_mm = output.needle.tent_mm;
  if (!output.needle.inBody) return sample;
  const Vec3 atRest_mm = context.restFromPatient * sample.patientFromNeedle->offset;
  sample.toVeinCenter_mm = vessels.distanceToCenterLine_mm(atRest_mm, veins);
  if (!grid) return sample;
  const TissueSample tissue = grid->at(atRest_mm);
  sample.toArtery_mm = distance(tissue, kArtery);
  sample.toLung_mm = distance(tissue, kAirway);
  return sample;
}

AttemptEvent makeEvent(const NeedleEvent& event, const TickContext& context, const SkinSurface* skin,
                       std::span<const CenterLine> veins, const VesselLocator& vessels) noexcept {
  AttemptEvent told;
  told.time_us = context.time_us, told.kind = kindOf(event.kind);
  told.wall = event.wall, told.into = event.into;
  told.tip_mm = event.tip_mm, told.axis = event.axis, told.depth_mm = event.depth_mm;
  if (event.wall == kVein || event.wall == kArtery)
    told.vessel = vessels.vesselAt(event.wall, context.restFromPatient * event.tip_mm, veins);
  if (!skin || event.wall != kSkin) return told;
  if (const auto hole_mm = holeOf(event, *skin)) told.outward = skin->normal(*hole_mm, -event.axis);
  return told;
}

ImageField imageFieldOf(const Probe& probe) {
  const SliceLaw slice = sliceLaw(probe, probe.defaultFrequency_MHz);
  ImageField field;
  field.sliceHalf_mm = slice.narrowest_mm / 2, field.elevationFocus_mm = slice.at_mm;
  field.elevationDivergence = slice.growthBefore, field.elevationDivergenceBehind = slice.growthBehind;
  if (probe.shape == ProbeShape::Linear) {
    field.width_mm = probe.width_mm;
  } else {
    field.fanAngle_deg = probe.fovAngle_deg, field.faceRadius_mm = probe.faceRadius_mm;
  }
  return field;
}

}  // namespace insonate
