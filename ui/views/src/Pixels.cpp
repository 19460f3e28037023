#include <insonate/views/Pixels.h>

#include <vtkRenderWindow.h>

namespace insonate::views {

/// OpenGL counts rows from the bottom and stores red first.
void PixelReader::read(vtkRenderWindow& window, Pixels& pixels) {
  const int* size = window.GetSize();
  pixels.width = size[0], pixels.height = size[1];
  const auto stride = std::size_t(pixels.width);
  pixels.argb.resize(stride * std::size_t(pixels.height));
  window.GetRGBACharPixelData(0, 0, pixels.width - 1, pixels.height - 1, 0, bytes_);
  for (int row = 0; row < pixels.height; ++row) {
    const unsigned char* from = bytes_->GetPointer(vtkIdType(4) * pixels.width * (pixels.height - 1 - row));
    std::uint32_t* to = pixels.argb.data() + stride * std::size_t(row);
    for (std::size_t k = 0; k < stride; ++k, from += 4)
      to[k] = 0xff000000U | std::uint32_t(from[0]) << 16 | std::uint32_t(from[1]) << 8 | from[2];
  }
}

}  // namespace insonate::views
