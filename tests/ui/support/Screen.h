#pragma once

#include "Golden.h"

#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace insonate::test {

/// A window that nobody sees, with a view in it.
template <class ViewType>
class Screen {
 public:
  Screen(ViewType& view, int width, int height, double scale = 1) : view_(view) {
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(0);
    window_->SetSize(width, height);
    view_.attach(window_);
    view_.resize(width, height, scale);
  }
  ~Screen() { view_.detach(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Renders and reads what is seen.
  Picture picture() {
    view_.render();
    const int* size = window_->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    window_->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 1, pixels);
    Picture picture{size[0], size[1], std::vector<std::uint8_t>(std::size_t(3) * size[0] * size[1])};
    const std::size_t stride = std::size_t(3) * size[0];
    for (int row = 0; row < size[1]; ++row)
      std::copy_n(pixels->GetPointer(0) + (size[1] - 1 - row) * stride, stride, picture.rgb.data() + row * stride);
    return picture;
  }
  vtkRenderWindow* window() { return window_; }

 private:
  ViewType& view_;
  vtkNew<vtkRenderWindow> window_;
};

}  // namespace insonate::test
