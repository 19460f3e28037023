#include <insonate/simulator/ServoRecord.h>

#include <algorithm>
#include <optional>

namespace insonate {
namespace {

/// A grid keeps distances up to 300 mm; one that is as far is of a structure that is not there.
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

/// The skin bends far before it gives: the tip is that much deeper than the hole, where skin may face another way.
Vec3 onSkin(const NeedleEvent& event, const Transform& restFromPatient, const TissueGrid& grid) {
  constexpr double kStep_mm = 0.25, kMost_mm = 20;
  const Vec3 tip_mm = restFromPatient * event.tip_mm, axis = normalized(restFromPatient.linear * event.axis);
  double back_mm = 0;
  while (back_mm < kMost_mm && grid.at(tip_mm - axis * back_mm).distance_mm[wallIndex(kSkin)] < 0) back_mm += kStep_mm;
  return tip_mm - axis * back_mm;
}

/// Over some millimetres, as an eye sees how skin lies, and not its unevenness. Length 1 where it is flat.
Vec3 outwardOfSkin(Vec3 at_mm, const TissueGrid& grid) {
  constexpr double kStep_mm = 3;
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step_mm;
    step_mm[axis] = kStep_mm;
    const auto skin_mm = [&](Vec3 point_mm) { return grid.at(point_mm).distance_mm[wallIndex(kSkin)]; };
    slope[axis] = (skin_mm(at_mm + step_mm) - skin_mm(at_mm - step_mm)) / (2 * kStep_mm);
  }
  return slope;
}

}  // namespace

AttemptSample sampleOf(const ServoOutput& output, const TickContext& context, const TissueGrid* grid,
                       std::span<const CentreLine> veins, const VesselNames& vessels) noexcept {
  AttemptSample sample;
  sample.time_us = context.time_us;
  if (context.present[kProbeHand]) sample.patientFromProbe = output.hands[kProbeHand].patientFromTool;
  sample.probeForce_N = output.skinForce_N;
  sample.pictureDepth_mm = context.pictureDepth_mm;
  sample.aspirating = context.aspirating;
  if (!context.present[kNeedleHand]) return sample;
  sample.patientFromNeedle = output.hands[kNeedleHand].patientFromTool;
  if (output.needle.inBody) sample.needleDepth_mm = output.needle.depth_mm;
  if (output.needle.tenting) sample.tenting_mm = output.needle.tent_mm;
  if (!output.needle.inBody) return sample;
  const Vec3 atRest_mm = context.restFromPatient * sample.patientFromNeedle->offset;
  sample.toVeinCentre_mm = vessels.distanceToCentre_mm(atRest_mm, veins);
  if (!grid) return sample;
  const TissueSample tissue = grid->at(atRest_mm);
  sample.toArtery_mm = distance(tissue, kArtery);
  sample.toLung_mm = distance(tissue, kAirway);
  return sample;
}

AttemptEvent eventOf(const NeedleEvent& event, const TickContext& context, const TissueGrid* grid,
                     std::span<const CentreLine> veins, const VesselNames& vessels) noexcept {
  AttemptEvent told;
  told.time_us = context.time_us, told.kind = kindOf(event.kind);
  told.wall = event.wall, told.into = event.into;
  told.tip_mm = event.tip_mm, told.axis = event.axis, told.depth_mm = event.depth_mm;
  if (event.wall == kVein || event.wall == kArtery)
    told.vessel = vessels.vesselAt(event.wall, context.restFromPatient * event.tip_mm, veins);
  if (!grid || event.wall != kSkin) return told;
  const Vec3 outward = outwardOfSkin(onSkin(event, context.restFromPatient, *grid), *grid);
  if (norm(outward) > 0.5) told.outward = normalized(outward);
  return told;
}

PictureField pictureFieldOf(const Probe& probe) {
  constexpr double kSound_mmMHz = 1.54;  // 1540 m/s
  PictureField field;
  field.sliceHalf_mm = probe.elevationFwhm_wavelengths * kSound_mmMHz / probe.defaultFrequency_MHz / 2;
  if (probe.shape == ProbeShape::Linear) {
    field.width_mm = probe.width_mm;
  } else {
    field.fanAngle_deg = probe.fovAngle_deg, field.faceRadius_mm = probe.faceRadius_mm;
  }
  return field;
}

}  // namespace insonate
