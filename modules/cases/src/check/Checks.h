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
  std::array<std::size_t, 256> inAir{};                   ///< of these, below -900 HU
  std::array<std::vector<std::uint32_t>, 256> histogram;  ///< of HU from lowest to highest, the ends take the rest
  int minHu = 0, maxHu = 0;

  bool has(int label) const { return voxels[label] > 0; }
  std::size_t labelled() const;
};

LabelStatistics statisticsOf(const CaseView& patient);
std::string labelName(int label);
/// "(1.0, -2.0, 3.0) mm"
std::string placeText(Vec3 patient_mm);
/// Patient LPS of the voxel with this offset.
Vec3 placeOf(const VolumeGeometry& geometry, std::size_t offset);
double voxelVolume_mm3(const VolumeGeometry& geometry);
/// The grid axis nearest to head-foot; the volume's ends along it are cuts through the body.
int headFootAxis(const VolumeGeometry& geometry);

/// Size and spacing of the volume, and whether there is an image in it.
void checkGrid(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Missing and unknown labels; HU that a label cannot have; labels in air.
void checkLabels(const CaseView& patient, const LabelStatistics& statistics, Findings& findings);
/// Closed skin, background inside the body, body cut by the volume's sides.
void checkBody(const CaseView& patient, Findings& findings);
/// Checks vein and artery: fragments, thinness, and whether a vessel to be punctured can be followed.
void checkVessel(const CaseView& patient, std::uint8_t label, Findings& findings);
/// Vein and artery that touch each other.
void checkWall(const CaseView& patient, Findings& findings);
/// Finds labels outside the body and very small parts.
void checkIslands(const CaseView& patient, Findings& findings);
/// Targets and start poses.
void checkPlaces(const CaseView& patient, Findings& findings);
/// Landmarks: which are missing, and whether they can be where they are.
void checkLandmarks(const CaseView& patient, Findings& findings);
/// No grade, or one that the labels contradict.
void checkDifficulty(const CaseView& patient, Findings& findings);

bool inVolume(const VolumeGeometry& geometry, Vec3 patient_mm);

}  // namespace insonate::check
