#pragma once

#include <insonate/core/Result.h>
#include <insonate/ultrasound/Probe.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// A photograph or screen capture of a machine's picture. Pixel (0, 0) is the upper left one; its center is (0, 0).
struct GreyPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> grey;  ///< [row][column]
};

struct PixelPoint {
  double x = 0, y = 0;
};

/// Position of a field of view in an image, in its pixels.
struct FovShape {
  ProbeShape shape = ProbeShape::Linear;
  PixelPoint origin;                      ///< fan: the virtual apex; linear: the middle of the face
  double rotation_deg = 0;                ///< of the axis from upright; positive where its far end leans to the right
  bool upsideDown = false;                ///< the face is below and depth runs upward
  double alpha_deg = 60;                  ///< fan: full angle
  double r1_px = 0, r2_px = 100;          ///< fan: from the apex to the face and to the end
  double width_px = 100, depth_px = 100;  ///< linear
};

/// The marks of a depth scale beside the picture.
struct DepthRuler {
  double spacing_px = 0;       ///< between neighboring marks, along the axis
  int marks = 0;               ///< seen
  int longEvery = 0;           ///< every n-th mark is a long one; 0 where all are alike
  double mmPerMark = 10;       ///< the likely meaning: numbers are not read
  std::vector<PixelPoint> at;  ///< the marks seen, from the face down
};

struct FovFit {
  FovShape shape;
  double confidence = 0;            ///< 0..1; below 0.5 it should be corrected by hand
  std::vector<std::string> doubts;  ///< sentences: what was not seen well
  std::optional<DepthRuler> ruler;
};

/// Finds the fan or rectangle of an ultrasound image, turned by up to 5 degrees, upright or upside down, light on dark
/// or dark on light, with text and bars around it, also with a side or the end cut off. Of two similar ones side by
/// side on a ground, it is the clearer one, or the left; a warning says so. The same image gives the same fit. Takes
/// up to a second, or three with two candidates. Fails, with a sentence, on images under 64 or over 16384 pixels wide
/// or high, and if nothing looks like a field of view.
Result<FovFit> fitFov(const GreyPicture& picture);

/// Distance from the middle of the face to the end, in pixels.
double depthOf_px(const FovShape& shape);
/// A point of the field of view: across -1..1 from its left to its right as seen from the face, down 0..1.
PixelPoint pointIn(const FovShape& shape, double across, double down);
/// Outline of the field of view as a closed line.
std::vector<PixelPoint> outlineOf(const FovShape& shape);

/// Makes a probe from an image: shape, angle, radii, width and the depth on display; all else is the base's.
/// `mm_per_px` is above 0. Fails if the result is no valid probe, and says which value is out of range.
Result<Probe> probeFromFit(const FovShape& shape, double mm_per_px, const Probe& base, std::string name);

}  // namespace insonate
