#pragma once

#include <insonate/segmentation/Region.h>
#include <insonate/segmentation/VesselCourse.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace insonate {

/// Size of a resampled image.
struct ImageSize {
  int width = 1, height = 1;  ///< pixels
  double mm_per_px = 1;
};

/// CT values and labels on a plane or a bent surface, row by row from the top left pixel.
struct ResampledImage {
  /// CT value of pixels outside of the CT or of the vessel's course.
  static constexpr std::int16_t kOutside = std::numeric_limits<std::int16_t>::min();

  ImageSize size;
  std::vector<std::int16_t> hu;
  std::vector<std::uint8_t> labels;  ///< 0 outside
};

/// The volumes from which an image is resampled. The object does not own them.
struct VesselVolumes {
  const CtVolume& ct;
  const LabelMap& labels;              ///< on the grid of the CT
  const Proposal* proposal = nullptr;  ///< if not null, its labels are shown instead of those that it would replace
};

/// Resamples the surface that contains the whole center line and, at each point of it, the direction
/// down cos(angle) + right sin(angle) of the frame there (curved planar reformation). The vessel is horizontal, and the
/// center line is in the middle row. The left edge of the image is at `from_mm` of the course. CT values are
/// interpolated trilinearly; labels are those of the nearest voxels. `former`, if not null, is an image of the same
/// surface and size, whose CT values are reused. Uses the threads of TBB.
ResampledImage straightened(const VesselVolumes& volumes, const VesselCourse& course, double from_mm, double angle_rad,
                            const ImageSize& size, const ResampledImage* former = nullptr);

/// Resamples a cross-section; the center of the frame is the center of the image. `former` as in straightened().
ResampledImage crossSection(const VesselVolumes& volumes, const VesselFrame& frame, const ImageSize& size,
                            const ResampledImage* former = nullptr);

}  // namespace insonate
