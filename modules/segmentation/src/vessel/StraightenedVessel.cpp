#include <insonate/segmentation/StraightenedVessel.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>

namespace insonate {
namespace {

/// Samples CT and labels at points of the patient.
class Sampler {
 public:
  Sampler(const VesselVolumes& volumes, bool hasCt)
      : volumes_(volumes), indexFromPatient_(volumes.ct.geometry.indexFromPatient()), hasCt_(hasCt) {}

  void sample(Vec3 patient_mm, std::int16_t& hu, std::uint8_t& label) const {
    const Vec3 index = indexFromPatient_ * patient_mm;
    const auto [i, j, k] = nearestVoxel(index);
    if (!volumes_.ct.geometry.contains(i, j, k)) return;
    if (!hasCt_) hu = static_cast<std::int16_t>(std::lround(sampleLinear(volumes_.ct, index)));
    label = volumes_.labels.at(i, j, k);
    const Proposal* proposal = volumes_.proposal;
    if (!proposal || !proposal->box.contains(i, j, k)) return;
    const auto& first = proposal->box.first;
    const std::uint8_t proposed = proposal->labels.at(i - first[0], j - first[1], k - first[2]);
    if (proposed != Proposal::kKeep) label = proposed;
  }

 private:
  const VesselVolumes& volumes_;
  Transform indexFromPatient_;
  bool hasCt_;  ///< true: the CT values are known
};

ResampledImage blank(const ImageSize& size, const ResampledImage* former) {
  ResampledImage image{size, {}, {}};
  const std::size_t pixels = std::size_t(size.width) * std::size_t(size.height);
  if (former)
    image.hu = former->hu;
  else
    image.hu.assign(pixels, ResampledImage::kOutside);
  image.labels.assign(pixels, 0);
  return image;
}

/// Position of a pixel relative to the middle of `count` pixels.
double offset_mm(int pixel, int count, double mm_per_px) {
  return (pixel + 0.5 - 0.5 * count) * mm_per_px;
}

}  // namespace

ResampledImage straightened(const VesselVolumes& volumes, const VesselCourse& course, double from_mm, double angle_rad,
                            const ImageSize& size, const ResampledImage* former) {
  ResampledImage image = blank(size, former);
  const Sampler sampler(volumes, former);
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  tbb::parallel_for(tbb::blocked_range<int>(0, size.width, 32), [&](const tbb::blocked_range<int>& columns) {
    for (int x = columns.begin(); x < columns.end(); ++x) {
      const double along_mm = from_mm + (x + 0.5) * size.mm_per_px;
      if (along_mm < 0 || along_mm > course.length_mm()) continue;
      const VesselFrame frame = course.at(along_mm);
      const Vec3 down = frame.down * c + frame.right * s;
      for (int y = 0; y < size.height; ++y) {
        const std::size_t pixel = std::size_t(y) * std::size_t(size.width) + std::size_t(x);
        sampler.sample(frame.center_mm + down * offset_mm(y, size.height, size.mm_per_px), image.hu[pixel],
                       image.labels[pixel]);
      }
    }
  });
  return image;
}

ResampledImage crossSection(const VesselVolumes& volumes, const VesselFrame& frame, const ImageSize& size,
                            const ResampledImage* former) {
  ResampledImage image = blank(size, former);
  const Sampler sampler(volumes, former);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const std::size_t pixel = std::size_t(y) * std::size_t(size.width) + std::size_t(x);
      const Vec3 at_mm = frame.center_mm + frame.right * offset_mm(x, size.width, size.mm_per_px) +
                         frame.down * offset_mm(y, size.height, size.mm_per_px);
      sampler.sample(at_mm, image.hu[pixel], image.labels[pixel]);
    }
  return image;
}

}  // namespace insonate
