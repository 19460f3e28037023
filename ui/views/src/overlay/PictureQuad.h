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

/// An image on a rectangle of the display, its first row on top.
class PictureQuad {
 public:
  PictureQuad(vtkRenderer& renderer, int components, bool interpolate);
  ~PictureQuad();

  /// The image's bytes, to be written to, of width * height * components; tell pictureChanged() afterwards. Allocates
  /// only when the size differs from the last one.
  std::span<std::uint8_t> picture(int width, int height);
  void pictureChanged();
  /// A part of the image, in shares of its width and height from its top left corner.
  struct Part {
    double left = 0, top = 0, right = 1, bottom = 1;
  };
  /// Places that part on this rectangle; left of right mirrors it.
  void place(DisplayPoint topLeft, DisplayPoint bottomRight, int height_px, const Part& part);
  void show(bool visible);

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
