#pragma once

#include "Rigid.h"

#include <insonate/camera/LensModel.h>
#include <insonate/camera/TagBody.h>

#include <array>
#include <optional>
#include <vector>

namespace insonate::camera {

/// A pose that was refined by the gray values of the printed tags.
struct AlignedPose {
  Transform cameraFromBody;
  Matrix<6, 6> information;     ///< inverse of the covariance, as in BodyPose (mm, rad)
  double blur_px = 0;           ///< standard deviation of the blur of lens and pixel
  double white = 0, black = 0;  ///< gray levels of paper and ink, mean of the tags
  double error = 0;             ///< root mean square difference from the model, relative to white - black
  int tags = 0;                 ///< number of tags used
};

/// Start of an alignment.
struct AlignmentStart {
  Transform cameraFromBody;
  Motion duringExposure;  ///< motion of the body from the beginning to the end of the exposure
  double blur_px = 0.7;
  bool isPrecise = false;  ///< true: within about a pixel; false: a wider neighborhood is searched first
};

/// Refines the pose of a body by dense alignment (DodecaPen, Wu et al. 2017): the printed cells of all tags that face
/// the camera, blurred as the image is, are fitted to the image's pixels by Gauss-Newton steps. Each pixel of the image
/// counts once, without interpolation. For each tag, paper and ink have gray levels of their own, which are eliminated
/// from the equations.
class PatternAlignment {
 public:
  explicit PatternAlignment(const LensModel& lens);

  /// Returns no value if fewer than `leastTags` tags agree with the image. The start must be within about 1.5 pixels
  /// plus the blur.
  std::optional<AlignedPose> align(const GrayView& image, const TagBody& body, const AlignmentStart& start,
                                   int leastTags = 1);

 private:
  static constexpr int kUnknowns = 7;  ///< motion, and width of the blur
  /// A pixel on a tag: gray level, model from 0 (ink) to 1 (paper), derivatives of the model by the unknowns.
  struct Sample {
    float gray = 0, model = 0;
    std::array<float, kUnknowns> slope{};
  };
  struct TagView;
  struct Sums;
  struct Photometry;

  std::optional<TagView> viewOf(const BodyTag& tag, const AlignmentStart& at) const;
  void sampleTag(const GrayView& image, const BodyTag& tag, const TagView& view, int step);
  std::optional<Photometry> photometryOf(bool isRobust, double leastCorrelation) const;
  void addTag(const Photometry& photometry, bool isRobust, Sums& sums) const;
  Sums sumsAt(const GrayView& image, const TagBody& body, const AlignmentStart& at, bool isCoarse);

  LensModel lens_;
  std::vector<float> rays_;  ///< x and y of the ray through each pixel's center
  std::vector<Sample> samples_;
};

}  // namespace insonate::camera
