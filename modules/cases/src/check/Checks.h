#pragma once

#include <insonate/cases/CaseCheck.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace insonate::check {

using Findings = std::vector<Finding>;

/// Statistics of each label, gathered in one pass over the volume.
struct LabelStatistics {
  static constexpr int kLowestHu = -1024, kHighestHu = 3071;
  std::array<std::size_t, 256> voxels{};
  std::array<std::size_t, 256> inAir{};  ///< number of each label's voxels whose CT value is below -900 HU
  std::array<std::vector<std::uint32_t>, 256> histogram;  ///< voxels of each label by HU, from kLowestHu to kHighestHu;
                                                          ///< the first and last entry include all values beyond
  int minHu = 0, maxHu = 0;

  bool has(int label) const { return voxels[label] > 0; }
  std::size_t labeled() const;
};

LabelStatistics statisticsOf(const CaseView& patient);
std::string labelName(int label);
/// Writes a position as "(1.0, -2.0, 3.0) mm".
std::string placeText(Vec3 patient_mm);
/// Returns the position (patient LPS) of the voxel with this offset.
Vec3 placeOf(const VolumeGeometry& geometry, std::size_t offset);
double voxelVolume_mm3(const VolumeGeometry& geometry);
/// Returns the grid axis nearest to the head-foot direction. At the volume's ends along this axis the body is cut.
int headFootAxis(const VolumeGeometry& geometry);

/// Checks size and spacing of the volume, and whether it contains an image.
void checkGrid(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Finds missing and unknown labels, implausible HU for a label, and labels in air.
void checkLabels(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Checks that the skin is closed; finds background inside the body, and a body that the volume's sides cut.
void checkBody(const CaseView& patient, Findings& findings);
/// Checks a vessel (the label of vein or artery) for fragments and thin parts, and whether a vessel to be punctured can
/// be followed.
void checkVessel(const CaseView& patient, std::uint8_t label, Findings& findings);
/// Finds veins and arteries whose lumen has CT values that blood cannot have.
void checkLumens(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Finds vein and artery that touch each other.
void checkWall(const CaseView& patient, Findings& findings);
/// Finds labels outside the body and very small connected parts.
void checkIslands(const CaseView& patient, Findings& findings);
/// Checks targets and start poses.
void checkPlaces(const CaseView& patient, Findings& findings);
/// Finds missing landmarks and landmarks at impossible positions.
void checkLandmarks(const CaseView& patient, Findings& findings);
/// Finds vessels that are larger than any such vessel, or of unusual size, along their courses and at the targets.
void checkSizes(const CaseView& patient, Findings& findings);
/// Finds a thyroid that is larger than most.
void checkThyroid(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Finds vessels and targets that lie on the other side than their names state, jugular veins medial of the carotid
/// artery, and vessels of the neck that do not run from head to foot.
void checkAnatomy(const CaseView& patient, Findings& findings);
/// Finds a missing grade, or a grade that the labels contradict.
void checkDifficulty(const CaseView& patient, Findings& findings);

/// Tells whether a target lies in a named vessel with its label.
bool liesIn(const NamedVessel& vessel, const Target& target);
bool inVolume(const VolumeGeometry& geometry, Vec3 patient_mm);

}  // namespace insonate::check
