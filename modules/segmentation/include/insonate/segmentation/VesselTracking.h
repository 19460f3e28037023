#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/Region.h>

#include <array>
#include <span>
#include <vector>

namespace insonate {

struct VesselTracking {
  /// maximum distance from the center of the vessel to its wall; doubled for flat vessels; 2 to 30
  double largest_mm = 12;
  /// standard deviation of the Gaussian blur of the CT in which the path between clicks is found; 0 to 3
  double smoothing_mm = 0.6;
};

/// Outline of a vessel in a section perpendicular to it, patient space. On ray n, the wall is at the distance
/// radius_mm[n] from the center in the direction right cos(a) + down sin(a), with a = 2 pi n / kRays.
struct VesselOutline {
  static constexpr int kRays = 36;
  Vec3 center_mm, right, down;
  std::array<double, kRays> radius_mm{};

  double area_mm2() const;
};

struct TrackedVessel {
  CenterLine line;                      ///< center line of the vessel, from the first to the last click
  std::vector<VesselOutline> outlines;  ///< outline of the wall at each point of the center line
  Selection lumen;
};

/// Tracks a vessel that is filled with contrast agent through the clicked points, in their order, and finds its wall in
/// cross-sections every millimeter. In each section, the outline is the star-shaped curve that best separates voxels
/// similar to the blood at the nearest clicks from darker voxels (muscle, fat) and brighter voxels (bone), and that
/// varies little around the vessel and along it. A vessel that touches bone or another vessel therefore keeps its
/// shape. The rays are stretched according to the flatness of the vessel. The CT value of blood is then measured again
/// in the sections.
///
/// On each ray, the wall is where the CT, averaged along the vessel, is halfway between the values of the blood and of
/// the tissue behind the wall. If that tissue is a thin layer, such as a stent or the tissue between two vessels, the
/// widening of the layer by blur is corrected. A section in which the vessel opens into a wider vessel gets the outline
/// of the nearest other section. The tracked vessel ends in planes at the first and the last click.
///
/// Refuses fewer than two clicks, clicks outside the CT, and clicks on blood whose CT value equals that of its
/// surroundings, since the wall is then invisible; fails when cancelled.
Result<TrackedVessel> trackVessel(const CtVolume& ct, std::span<const Vec3> clicks_mm, const VesselTracking& how = {},
                                  const Progress& progress = {});

}  // namespace insonate
