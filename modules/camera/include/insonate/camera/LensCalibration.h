#pragma once

#include <insonate/camera/CameraFrame.h>
#include <insonate/camera/LensModel.h>
#include <insonate/camera/TagBody.h>
#include <insonate/camera/TagDetector.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace insonate {

/// Returns the tags of the printed board. The board frame has its origin in the middle of the board, x to the right, y
/// up, z toward the viewer; mm.
const std::vector<BodyTag>& lensBoard();

/// Result of one image of the board.
enum class BoardView : std::uint8_t {
  kTaken,    ///< the image counts
  kNoBoard,  ///< fewer than four tags of the board were found
  kSimilar,  ///< an image from nearly the same direction and place was taken before
};

struct LensCalibration {
  LensModel lens;
  double error_px = 0;  ///< root mean square distance between detected and projected corners
  int views = 0;        ///< number of images used
};

/// Computes the lens from images of the printed board in different places and directions (Zhang 2000): focal lengths,
/// principal point, k1, k2, p1 and p2. Use an object on one thread at a time.
class LensCalibrator {
 public:
  /// Number of images that calibrate() needs.
  static constexpr int kLeastViews = 8;

  /// `width` and `height` are those of the camera's images, pixels.
  LensCalibrator(int width, int height);
  ~LensCalibrator();
  LensCalibrator(LensCalibrator&&) noexcept;
  LensCalibrator& operator=(LensCalibrator&&) noexcept;

  /// Looks for the board in an image and keeps its corners if they add something new.
  BoardView add(const CameraFrame& frame);
  /// Keeps the corners of an image that were detected before.
  BoardView add(const std::vector<TagDetection>& detections);
  /// Number of images taken so far.
  int views() const;
  /// Computes the lens. Takes about a second. Fails with a sentence if there are too few images, if all of them show
  /// the board from the same direction, or if the corners do not fit to a lens.
  Result<LensCalibration> calibrate() const;

 private:
  struct Views;
  std::unique_ptr<Views> views_;
};

}  // namespace insonate
