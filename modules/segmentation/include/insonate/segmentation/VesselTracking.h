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
  double largest_mm = 12;     ///< no wall is looked for farther from the middle, of a flat vessel twice as far; 2 to 30
  double smoothing_mm = 0.6;  ///< standard deviation of the blur of the CT in which the way is found; 0 to 3
};

/// A section perpendicular to a vessel, in the patient: the wall lies radius_mm[n] from the center along right cos(a)
/// + down sin(a), a = 2 pi n / kRays.
struct VesselOutline {
  static constexpr int kRays = 36;
  Vec3 centre_mm, right, down;
  std::array<double, kRays> radius_mm{};

  double area_mm2() const;
};

struct TrackedVessel {
  CentreLine line;                      ///< from the first to the last click
  std::vector<VesselOutline> outlines;  ///< one for each point of the line
  Selection lumen;
};

/// Follows a vessel filled with contrast agent between points that were clicked in it, in this order, and finds its
/// wall in sections a millimeter apart. Each section takes the star-shaped outline that best parts what looks like
/// the blood at the nearest clicks from what does not, be it darker (muscle, fat) or brighter (bone), and that changes
/// little around the vessel and along it; so a vessel that touches bone, or another one, keeps its shape. Rays
/// are stretched as the vessel is flat, and how bright its blood is gets measured in the sections. On each ray the wall
/// is half-way from the blood to what lies behind it; where that is thin, as a stent or what parts two vessels, blur is
/// taken off its width. For that, the CT is averaged along the vessel. Where it opens into a wider one, it keeps the
/// outline that it has beside. It ends flat at the first and last click.
/// Refuses fewer than two clicks, clicks beside the CT, and clicks whose blood is as dark as what surrounds it, since
/// there is no wall to be seen then; fails when cancelled.
Result<TrackedVessel> trackVessel(const CtVolume& ct, std::span<const Vec3> clicks_mm, const VesselTracking& how = {},
                                  const Progress& progress = {});

}  // namespace insonate
