#include "Checks.h"

#include <insonate/cases/StartPose.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::check {
namespace {

/// Tells whether a voxel with this label lies within 2 mm, the accuracy of a click by hand.
bool isBeside(const LabelMap& labels, Vec3 place_mm, std::uint8_t label) {
  constexpr double kBeside_mm = 2, kStep_mm = 0.5;
  constexpr int kSteps = static_cast<int>(kBeside_mm / kStep_mm);
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  for (int k = -kSteps; k <= kSteps; ++k)
    for (int j = -kSteps; j <= kSteps; ++j)
      for (int i = -kSteps; i <= kSteps; ++i) {
        const Vec3 offset_mm = kStep_mm * Vec3{double(i), double(j), double(k)};
        if (norm(offset_mm) <= kBeside_mm && sampleNearest(labels, indexFromPatient * (place_mm + offset_mm)) == label)
          return true;
      }
  return false;
}

void checkTarget(const CaseView& patient, const Target& target, Findings& findings) {
  const VolumeGeometry& g = patient.labels.geometry;
  const std::string what = "The target \"" + target.name + "\" at " + placeText(target.position_mm);
  if (!inVolume(g, target.position_mm)) {
    findings.push_back({FindingSeverity::kError, "target_outside",
                        what + " lies outside the volume. Correct case.json.", target.position_mm});
    return;
  }
  const int label = sampleNearest(patient.labels, g.indexFromPatient() * target.position_mm);
  if (label != target.label)
    findings.push_back({FindingSeverity::kError, "target_label",
                        what + " should be in " + labelName(target.label) + ", but the label there is " +
                            labelName(label) + ". Correct its position or the label map.",
                        target.position_mm, target.label});
}

/// Greatest depth of the face of a usual linear probe below the skin, in its image plane. Across hollow skin, the ends
/// of the face lie deep in it although its middle only touches.
double indentation_mm(const LabelMap& labels, const StartPose& pose) {
  constexpr double kHalfFace_mm = 19, kColumn_mm = 2, kReach_mm = 15, kStep_mm = 0.25;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  double deepest_mm = 0;
  for (double x_mm = -kHalfFace_mm; x_mm <= kHalfFace_mm; x_mm += kColumn_mm)
    for (double depth_mm = 0; depth_mm <= kReach_mm; depth_mm += kStep_mm) {
      const Vec3 at_mm = pose.position_mm + x_mm * pose.lateral - depth_mm * pose.axial;
      if (sampleNearest(labels, indexFromPatient * at_mm) == kBackground) break;
      deepest_mm = std::max(deepest_mm, depth_mm);
    }
  return deepest_mm;
}

void checkPose(const CaseView& patient, const StartPose& pose, bool labeled, Findings& findings) {
  const VolumeGeometry& g = patient.labels.geometry;
  const std::string what = "The start pose \"" + pose.name + "\" at " + placeText(pose.position_mm);
  if (!inVolume(g, pose.position_mm)) {
    findings.push_back({FindingSeverity::kError, "pose_outside", what + " lies outside the volume. Correct case.json.",
                        pose.position_mm});
    return;
  }
  if (!labeled) return;
  constexpr double kIn_mm = 3, kOut_mm = 5;
  const auto labelAt = [&](double depth_mm) {
    return sampleNearest(patient.labels, g.indexFromPatient() * (pose.position_mm + depth_mm * pose.axial));
  };
  if (labelAt(kIn_mm) == kBackground || labelAt(-kOut_mm) != kBackground) {
    findings.push_back({FindingSeverity::kWarning, "pose_off_skin",
                        what + " is not on the skin, or does not point into the body. The image may be empty at the "
                               "start. Correct the pose.",
                        pose.position_mm});
    return;
  }
  // The skin of a label map is a staircase of slices.
  const double tolerated_mm = 2.5 + g.spacing_mm.z / 2;
  if (const double deep_mm = indentation_mm(patient.labels, pose); deep_mm > tolerated_mm)
    findings.push_back({FindingSeverity::kInfo, "pose_compresses",
                        what + " presses a part of the face " + std::to_string(std::lround(deep_mm)) +
                            " mm into the skin, which is not flat there. The vein may be compressed at the start. Turn "
                            "or move the pose until the face only touches.",
                        pose.position_mm});
}

}  // namespace

bool inVolume(const VolumeGeometry& g, Vec3 p_mm) {
  const Vec3 index = g.indexFromPatient() * p_mm;
  for (int a = 0; a < 3; ++a)
    if (!(index[a] >= -0.5 && index[a] <= g.size[a] - 0.5)) return false;
  return true;
}

std::string placeText(Vec3 p) {
  std::array<char, 96> text;
  std::snprintf(text.data(), text.size(), "(%.1f, %.1f, %.1f) mm", p.x, p.y, p.z);
  return text.data();
}

Vec3 placeOf(const VolumeGeometry& g, std::size_t offset) {
  const std::size_t row = offset / std::size_t(g.size[0]);
  return g.patientFromIndex() * Vec3{double(offset % std::size_t(g.size[0])), double(row % std::size_t(g.size[1])),
                                     double(row / std::size_t(g.size[1]))};
}

void checkNames(const CaseView& patient, Findings& findings) {
  const CaseManifest& m = patient.manifest;
  if (m.vessels.empty() && !m.targets.empty())
    findings.push_back(
        {FindingSeverity::kInfo, "no_vessel_names",
         "The vessels have no names. An attempt can distinguish the vein of the target from other veins, but its "
         "messages call each of these \"another vein\". Name the vessels under Targets and landmarks."});
  for (const Target& target : m.targets) {
    const auto holdsTarget = [&](const NamedVessel& vessel) { return liesIn(vessel, target); };
    if (!m.vessels.empty() && std::ranges::none_of(m.vessels, holdsTarget))
      findings.push_back({FindingSeverity::kInfo, "target_without_vessel",
                          "The target '" + target.name +
                              "' lies in a vessel without a name. The messages of an attempt then call each other vein "
                              "\"another vein\". Name this vessel under Targets and landmarks.",
                          target.position_mm});
  }
  const VolumeGeometry& g = patient.labels.geometry;
  for (const NamedVessel& vessel : m.vessels) {
    int here = 0, labeled = 0;
    for (const NamedVessel::Point& point : vessel.course) {
      if (!inVolume(g, point.position_mm)) continue;
      ++here;
      labeled += tissueOf(m.ownLabels, sampleNearest(patient.labels, g.indexFromPatient() * point.position_mm)) ==
                 vessel.label;
    }
    if (2 * labeled >= here) continue;
    findings.push_back({FindingSeverity::kWarning, "vessel_elsewhere",
                        "Only " + std::to_string(labeled) + " of the " + std::to_string(here) + " points of the " +
                            vessel.name + " are labeled " + labelName(vessel.label) +
                            ". Correct the label, or the vessel's course in case.json.",
                        vessel.course.front().position_mm, vessel.label});
  }
}

/// Finds the author's clicks that do not lie in the vessel that was made from them.
void checkClicks(const CaseView& patient, const NamedVessel& vessel, Findings& findings) {
  const VolumeGeometry& g = patient.labels.geometry;
  for (const Vec3& click_mm : vessel.clicks_mm) {
    if (!inVolume(g, click_mm) || isBeside(patient.labels, click_mm, vessel.label)) continue;
    const int label = sampleNearest(patient.labels, g.indexFromPatient() * click_mm);
    findings.push_back({FindingSeverity::kWarning, "click_outside",
                        "The click for the " + vessel.name + " at " + placeText(click_mm) + " lies on " +
                            labelName(label) + ", outside the " + labelName(vessel.label) +
                            ". Click in the vessel instead and repeat the step, or label the vessel there.",
                        click_mm, vessel.label});
  }
}

void checkPlaces(const CaseView& patient, Findings& findings) {
  const CaseManifest& m = patient.manifest;
  const bool labeled = std::ranges::any_of(patient.labels.voxels, [](std::uint8_t v) { return v != 0; });
  if (m.targets.empty())
    findings.push_back({FindingSeverity::kWarning, "no_target",
                        "The case has no target, so an attempt has nothing to puncture. Mark a target in the vein."});
  for (const Target& target : m.targets) checkTarget(patient, target, findings);
  checkNames(patient, findings);
  for (const NamedVessel& vessel : m.vessels) checkClicks(patient, vessel, findings);
  for (const StartPose& pose : m.startPoses) checkPose(patient, pose, labeled, findings);
  if (!m.startPoses.empty()) return;
  if (const auto proposed = proposeStartPose(patient))
    findings.push_back({FindingSeverity::kInfo, "no_start_pose",
                        "The case has no start pose; the probe begins here: " + proposed->name + ".",
                        proposed->position_mm});
  else
    findings.push_back(
        {FindingSeverity::kWarning, "no_start_pose", "The case has no start pose. " + proposed.error().message});
}

}  // namespace insonate::check
