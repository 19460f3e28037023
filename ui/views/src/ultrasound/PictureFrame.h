#pragma once

#include "../overlay/Lines.h"
#include "../overlay/Texts.h"

#include <optional>
#include <string>
#include <vector>

namespace insonate::views {

/// Elements that are drawn around the ultrasound image.
struct PictureFrame {
  double left_px = 0, top_px = 0, right_px = 0, bottom_px = 0;  ///< edges of the image
  double px_per_mm = 10;
  double minAxial_mm = 0, maxAxial_mm = 40;
  std::optional<double> focus_mm{};
  std::vector<double> tgc_dB{};
  bool scale = true, grayBar = true, frozen = false;
  DisplayPoint marker_px{};  ///< the image's upper corner on the side of the probe's marker
  bool markerRight = true;   ///< true: `marker_px` is the right upper corner; false: the left one
  std::string notice{};
};

/// Space that the frame needs beside the image, in logical pixels.
inline constexpr double kFrameLeft = 52, kFrameRight = 44, kFrameTop = 26, kFrameBottom = 14;

void drawPictureFrame(const PictureFrame& frame, double scale, int width_px, Lines& lines, Texts& texts);

/// Returns the distance between the scale's numbers: the smallest of 1, 2, 5, 10, 20, 50 mm that leaves `room_px`
/// between them.
double tickStep_mm(double px_per_mm, double room_px);

}  // namespace insonate::views
