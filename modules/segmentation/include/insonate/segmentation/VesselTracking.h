#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/segmentation/Region.h>

#include <array>
#include <span>
#include <vector>

namespace insonate {

struct VesselTracking {
  double largest_mm = 12;     ///< maximum distance of the wall from the center, doubled for flat vessels; 2 to 30
  double smoothing_mm = 0.6;  ///< standard deviation of the CT's blur for finding the path between clicks; 0 to 3
};

/// A section perpendicular to a vessel, in the patient: the wall is at the distance radius_mm[n] from the center in the
/// direction right cos(a) + down sin(a), a = 2 pi n / kRays.
struct VesselOutline {
  static constexpr int kRays = 36;
  Vec3 centre_mm, right, down;
  std::array<double, kRays> radius_mm{};

  double area_mm2() const;
};

struct TrackedVessel {
  CentreLine line;                      ///< center line of the vessel, from the first to the last click
  std::vector<VesselOutline> outlines;  ///< outline of the wall at each point of the center line
  Selection lumen;
};

/// Follows a vessel filled with contrast agent between points that were clicked in it, in this order, and finds its
/// wall in sections a millimeter apart. Each section takes the star-shaped outline that best separates voxels similar
/// to the blood at the nearest clicks from darker (muscle, fat) and brighter (bone) voxels, and that changes little
/// around the vessel and along it. A vessel that touches bone or another vessel therefore keeps its shape. The rays are
/// stretched according to the vessel's flatness. The brightness of blood is measured again in the sections.
///
/// On each ray, the wall is at half the difference between the blood and the tissue behind the wall, in a CT averaged
/// along the vessel. If that tissue is a thin layer, such as a stent or the layer between two vessels, its widening by
/// blur is corrected. Sections that open into a wider vessel take the outline of the nearest section that does not. The
/// vessel ends flat at the first and last click.
///
/// Refuses fewer than two clicks, clicks outside the CT, and clicks on blood that is as dark as its surroundings, since
/// the wall is then invisible; fails when cancelled.
Result<TrackedVessel> trackVessel(const CtVolume& ct, std::span<const Vec3> clicks_mm, const VesselTracking& how = {},
                                  const Progress& progress = {});

}  // namespace insonate
