#pragma once

#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/Frames.h>
#include <insonate/video/VideoWriter.h>

#include <cstdint>
#include <memory>
#include <string>

namespace insonate::video {

/// sRGB color, components 0 to 255.
struct Ink {
  std::uint8_t red = 0, green = 0, blue = 0;
};

struct Box {
  double left = 0, top = 0, width = 0, height = 0;
  double right() const { return left + width; }
  double bottom() const { return top + height; }
};

enum class Align { Left, Center, Right };

struct TextStyle {
  double size_px = 16;
  Ink ink{};
  bool isBold = false;
  Align align = Align::Left;
};

/// Draws text, lines and images into memory (Cairo). Positions in pixels from the upper left corner.
class Canvas {
 public:
  Canvas(int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Fills a box; `opacity` 0..1.
  void fill(const Box& box, Ink ink, double opacity = 1);
  void line(double x0, double y0, double x1, double y1, double width_px, Ink ink);
  void disc(double x, double y, double radius_px, Ink ink);
  /// Draws an image with its color Doppler into a box, smoothly.
  void image(const BModeImage& image, const ColorImage& color, const Box& box);
  /// Writes a text with its baseline at `y`, smaller if it is wider than `max_px`, and returns its width.
  double text(double x, double y, const std::string& text, const TextStyle& style, double max_px = 1e9);
  /// Copies what was drawn.
  void copyTo(VideoFrame& frame) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace insonate::video
