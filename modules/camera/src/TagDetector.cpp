#include <insonate/camera/TagBody.h>
#include <insonate/camera/TagDetector.h>

#include <apriltag/apriltag.h>
#include <apriltag/tag25h9.h>

#include <algorithm>

namespace insonate {
namespace {

struct FamilyDeleter {
  void operator()(apriltag_family_t* family) const { tag25h9_destroy(family); }
};
using Family = std::unique_ptr<apriltag_family_t, FamilyDeleter>;

std::vector<TagPattern> drawnPatterns() {
  const Family family(tag25h9_create());
  std::vector<TagPattern> patterns;
  for (int id = 0; id < kTagCount; ++id) {
    TagPattern pattern{};
    for (int y = 0; y < kTagCellsWithBorder; ++y)
      for (int x = 0; x < kTagCellsWithBorder; ++x)
        if (std::min({x, y, kTagCells + 1 - x, kTagCells + 1 - y}) == 0)
          pattern[std::size_t(y) * kTagCellsWithBorder + std::size_t(x)] = 1;
    for (std::uint32_t bit = 0; bit < family->nbits; ++bit)
      if (family->codes[id] >> (family->nbits - 1 - bit) & 1)
        pattern[std::size_t(family->bit_y[bit] + 1) * kTagCellsWithBorder + family->bit_x[bit] + 1] = 1;
    patterns.push_back(pattern);
  }
  return patterns;
}

}  // namespace

const TagPattern& tagPattern(int id) {
  static const std::vector<TagPattern> patterns = drawnPatterns();
  return patterns.at(std::size_t(id));
}

struct TagDetector::Library {
  struct DetectorDeleter {
    void operator()(apriltag_detector_t* d) const { apriltag_detector_destroy(d); }
  };
  Family family{tag25h9_create()};
  std::unique_ptr<apriltag_detector_t, DetectorDeleter> detector{apriltag_detector_create()};
};

TagDetector::TagDetector() : library_(std::make_unique<Library>()) {
  // One wrong cell at most: with more, squares of the background are read as tags too often.
  apriltag_detector_add_family_bits(library_->detector.get(), library_->family.get(), 1);
  library_->detector->nthreads = 1;
  // Noise of dim images has edges of a few gray levels, and small squares cannot be read; both cost time.
  library_->detector->qtp.min_white_black_diff = 16;
  library_->detector->qtp.min_cluster_pixels = 24;
}
TagDetector::~TagDetector() = default;
TagDetector::TagDetector(TagDetector&&) noexcept = default;
TagDetector& TagDetector::operator=(TagDetector&&) noexcept = default;

void TagDetector::detect(const GrayView& image, FrameBox box, int decimation, std::vector<TagDetection>& found) {
  const int left = std::clamp(box.left, 0, image.width), top = std::clamp(box.top, 0, image.height);
  const int right = std::clamp(box.left + box.width, left, image.width);
  const int bottom = std::clamp(box.top + box.height, top, image.height);
  constexpr int kLeast_px = 12;
  if (right - left < kLeast_px || bottom - top < kLeast_px) return;
  // The library does not write to the image, although its type permits this.
  auto* pixels = const_cast<std::uint8_t*>(image.pixels) + std::ptrdiff_t(top) * image.stride + left;
  image_u8_t part = {right - left, bottom - top, image.stride, pixels};
  library_->detector->quad_decimate = float(decimation);
  zarray_t* detections = apriltag_detector_detect(library_->detector.get(), &part);
  for (int i = 0; i < zarray_size(detections); ++i) {
    apriltag_detection_t* d = nullptr;
    zarray_get(detections, i, static_cast<void*>(&d));
    TagDetection tag;
    tag.id = d->id, tag.correctedBits = d->hamming, tag.margin = d->decision_margin;
    for (std::size_t c = 0; c < 4; ++c) tag.corners[c] = {d->p[c][0] + left, d->p[c][1] + top};
    found.push_back(tag);
  }
  apriltag_detections_destroy(detections);
}

}  // namespace insonate
