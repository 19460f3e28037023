#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Probe.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// An 8-bit gray image, e.g. a photograph or screen capture of an ultrasound machine's image. Pixel (0, 0) is at the
/// upper left; its center has the coordinates (0, 0).
struct GrayImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> gray;  ///< gray values, index [row][column]
};

struct PixelPoint {
  double x = 0, y = 0;
};

/// Shape and position of a field of view in an image, in pixels of the image.
struct FovShape {
  ProbeShape shape = ProbeShape::Linear;
  PixelPoint origin;              ///< fan: the virtual apex; linear: the middle of the face
  double rotation_deg = 0;        ///< angle between the axis and the vertical; positive: the far end is to the right
  bool upsideDown = false;        ///< true if the face is at the bottom and depth runs upward
  double alpha_deg = 60;          ///< fan: full opening angle
  double r1_px = 0, r2_px = 100;  ///< fan: distances from the virtual apex to the face (r1) and to the far end (r2)
  double width_px = 100, depth_px = 100;  ///< linear: size of the rectangle along the face and along the depth
};

/// The marks of a depth scale beside the ultrasound image.
struct DepthRuler {
  double spacing_px = 0;  ///< distance between neighboring marks of the depth scale, along its axis
  int marks = 0;          ///< number of marks found
  int longEvery = 0;      ///< n: every n-th mark is longer; 0: all marks have the same length
  /// most probable distance in mm between marks, estimated without reading numbers in the image
  double mmPerMark = 10;
  std::vector<PixelPoint> at;  ///< positions of the marks found, from the face downward
};

struct FovFit {
  FovShape shape;
  double confidence = 0;  ///< confidence of the fit, 0 to 1; below 0.5 the user should correct the fit
  /// warnings about edges of the field of view that were not clearly visible, one sentence each
  std::vector<std::string> warnings;
  std::optional<DepthRuler> ruler;
};

/// Finds the fan or rectangle of an ultrasound image: turned by up to 5 degrees, upright or upside down, light on dark
/// or dark on light, with text and bars around it, and possibly with a side or the end cut off. If two similar images
/// lie side by side, the clearer one is used, or the left one if both are equally clear, and a warning says so. The
/// same image gives the same fit. Takes up to a second, or three with two candidates. Fails with a sentence on images
/// less than 64 or more than 16384 pixels wide or high, and if no field of view is found.
Result<FovFit> fitFov(const GrayImage& picture);

/// Returns the distance from the middle of the face to the far end of the field of view, in pixels.
double depthOf_px(const FovShape& shape);
/// Returns a point of the field of view. `acrossFraction`: -1 at the left edge to 1 at the right edge, as seen from the
/// face; `depthFraction`: 0 at the face to 1 at the far end.
PixelPoint pointAtFraction(const FovShape& shape, double acrossFraction, double depthFraction);
/// Returns the outline of the field of view as a closed polygon, in pixels.
std::vector<PixelPoint> outlineOf(const FovShape& shape);

/// Makes a probe from a fit: shape, angle, radii, width and displayed depth are those of the fit, all other values
/// those of `base`. `mm_per_px` must be above 0. Fails with a sentence that names the value that is out of range.
Result<Probe> probeFromFit(const FovShape& shape, double mm_per_px, const Probe& base, std::string name);

}  // namespace insonate
