#pragma once

#include <insonate/camera/CameraFrame.h>

#include <array>
#include <memory>
#include <vector>

namespace insonate {

/// A tag that was found in an image.
struct TagDetection {
  int id = 0;
  std::array<FramePoint, 4> corners;  ///< bottom left, bottom right, top right, top left, as the tag is read
  int correctedBits = 0;              ///< number of cells that were read wrong
  double margin = 0;                  ///< mean difference between cells and threshold, gray levels
};

/// Finds tags of the family 25h9 in gray images (AprilTag 3). Use an object on one thread at a time.
class TagDetector {
 public:
  TagDetector();
  ~TagDetector();
  TagDetector(TagDetector&&) noexcept;
  TagDetector& operator=(TagDetector&&) noexcept;

  /// Appends the tags in a part of the image to `found`, with corners in pixels of the whole image. `box` is clipped to
  /// the image. `decimation` 2 looks for squares in an image of half the size, which is four times faster but misses
  /// tags that are smaller than about 30 pixels.
  void detect(const GrayView& image, FrameBox box, int decimation, std::vector<TagDetection>& found);

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace insonate
