#pragma once

#include <insonate/views/Input.h>

#include <vtkNew.h>

#include <cstdint>
#include <span>

class vtkFloatArray;
class vtkImageData;
class vtkPoints;
class vtkRenderer;
class vtkTexture;
class vtkTexturedActor2D;
class vtkUnsignedCharArray;

namespace insonate::views {

/// Draws an image in a rectangle of the display, with its first row on top.
class ImageQuad {
 public:
  ImageQuad(vtkRenderer& renderer, int components, bool interpolate);
  ~ImageQuad();

  /// Returns the image's buffer of width * height * components bytes for writing; call pictureChanged() afterwards.
  /// Allocates memory only if the size has changed.
  std::span<std::uint8_t> picture(int width, int height);
  void pictureChanged();
  /// A part of the image, as fractions of its width and height from its top left corner.
  struct Part {
    double left = 0, top = 0, right = 1, bottom = 1;
  };
  /// Places a part of the image in a rectangle of the display; the image is mirrored if bottomRight is to the left of
  /// topLeft.
  void place(DisplayPoint topLeft, DisplayPoint bottomRight, int height_px, const Part& part);
  void show(bool visible);
  /// Sets a factor for all values, 0 to 1.
  void setBrightness(double factor);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkImageData> image_;
  vtkNew<vtkUnsignedCharArray> bytes_;
  vtkNew<vtkTexture> texture_;
  vtkNew<vtkPoints> corners_;
  vtkNew<vtkFloatArray> coordinates_;
  vtkNew<vtkTexturedActor2D> actor_;
  int components_;
};

}  // namespace insonate::views
