#pragma once

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <cstdint>
#include <vector>

class vtkRenderWindow;

namespace insonate::views {

/// Contents of a window as 0xffRRGGBB, the top row first.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> argb;
};

/// Reads pixels from a window, on the thread that renders the window. Allocates memory only when the size changes.
class PixelReader {
 public:
  void read(vtkRenderWindow& window, Pixels& pixels);

 private:
  vtkNew<vtkUnsignedCharArray> bytes_;  ///< pixels in OpenGL's format
};

}  // namespace insonate::views
