#include "Guarded.h"

#include <insonate/segmentation/FillBetweenSlices.h>

#include <itkImage.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace insonate {
namespace {

/// One slice of a selection as an image with two axes.
class SlicePlane {
 public:
  SlicePlane(Selection& selection, int axis)
      : selection_(selection), axis_(axis), across_{axis == 0 ? 1 : 0, axis == 2 ? 1 : 2} {}

  int width() const { return selection_.mask.geometry.size[across_[0]]; }
  int height() const { return selection_.mask.geometry.size[across_[1]]; }
  double spacing_mm(int a) const { return selection_.mask.geometry.spacing_mm[across_[a]]; }
  std::uint8_t& at(int x, int y, int slice) const {
    std::array<int, 3> index{};
    index[axis_] = slice, index[across_[0]] = x, index[across_[1]] = y;
    return selection_.mask.at(index[0], index[1], index[2]);
  }

 private:
  Selection& selection_;
  int axis_;
  std::array<int, 2> across_;
};

/// Signed distance of each point of a slice from the outline, mm, positive inside; and the center of the outline.
struct Drawing {
  int slice = 0, width = 0, height = 0;
  double x = 0, y = 0;  ///< centroid, in voxels
  std::vector<float> inside_mm;

  /// Bilinear; outside the slice, the value at its edge.
  double sample(double px, double py) const {
    px = std::clamp(px, 0.0, width - 1.0), py = std::clamp(py, 0.0, height - 1.0);
    const int left = std::min(static_cast<int>(px), std::max(0, width - 2)), right = std::min(left + 1, width - 1);
    const int top = std::min(static_cast<int>(py), std::max(0, height - 2)), low = std::min(top + 1, height - 1);
    const double fx = px - left, fy = py - top;
    const auto value = [&](int i, int j) { return double(inside_mm[std::size_t(j) * width + i]); };
    return (value(left, top) * (1 - fx) + value(right, top) * fx) * (1 - fy) +
           (value(left, low) * (1 - fx) + value(right, low) * fx) * fy;
  }
};

using Picture = itk::Image<std::uint8_t, 2>;

/// Distance of each point to the nearest pixel of value 1; 0 at those.
std::vector<float> distances_mm(Picture* picture) {
  auto maurer = itk::SignedMaurerDistanceMapImageFilter<Picture, itk::Image<float, 2>>::New();
  maurer->SetInput(picture);
  maurer->SetUseImageSpacing(true);
  maurer->SetSquaredDistance(false);
  maurer->Update();
  const float* const signed_mm = maurer->GetOutput()->GetBufferPointer();
  std::vector<float> distances(picture->GetLargestPossibleRegion().GetNumberOfPixels());
  std::transform(signed_mm, signed_mm + distances.size(), distances.begin(),
                 [](float mm) { return std::max(mm, 0.F); });
  return distances;
}

std::optional<Drawing> drawingOf(const SlicePlane& plane, int slice) {
  Drawing drawing{slice, plane.width(), plane.height(), 0, 0, {}};
  auto picture = Picture::New();
  picture->SetRegions(Picture::SizeType{{itk::SizeValueType(plane.width()), itk::SizeValueType(plane.height())}});
  const double spacing_mm[2] = {plane.spacing_mm(0), plane.spacing_mm(1)};
  picture->SetSpacing(spacing_mm);
  picture->Allocate();
  std::uint8_t* const pixels = picture->GetBufferPointer();
  std::size_t count = 0, n = 0;
  for (int y = 0; y < plane.height(); ++y)
    for (int x = 0; x < plane.width(); ++x, ++n) {
      pixels[n] = plane.at(x, y, slice);
      if (pixels[n]) drawing.x += x, drawing.y += y, ++count;
    }
  if (count == 0) return std::nullopt;
  drawing.x /= double(count), drawing.y /= double(count);
  const std::vector<float> outside_mm = distances_mm(picture);
  for (std::size_t p = 0; p < n; ++p) pixels[p] ^= 1;
  drawing.inside_mm = distances_mm(picture);
  std::ranges::transform(drawing.inside_mm, outside_mm, drawing.inside_mm.begin(), std::minus<>());
  return drawing;
}

void blend(const SlicePlane& plane, const Drawing& a, const Drawing& b, int slice) {
  const double t = double(slice - a.slice) / (b.slice - a.slice);
  const double x = a.x * (1 - t) + b.x * t, y = a.y * (1 - t) + b.y * t;
  for (int j = 0; j < plane.height(); ++j)
    for (int i = 0; i < plane.width(); ++i) {
      const double mm = (1 - t) * a.sample(i - x + a.x, j - y + a.y) + t * b.sample(i - x + b.x, j - y + b.y);
      plane.at(i, j, slice) = mm > 0;
    }
}

}  // namespace

Result<Selection> fillBetweenSlices(const Selection& slices, int axis, const Progress& progress) {
  bool filled = false;
  auto result = segmentation::guarded([&] {
    Selection whole = slices;
    if (whole.box.empty()) return whole;
    const SlicePlane plane(whole, axis);
    std::optional<Drawing> last;
    const int count = whole.box.length(axis);
    for (int slice = 0; slice < count; ++slice) {
      if (!report(progress, "Filling between slices", double(slice) / count)) throw segmentation::Cancelled{};
      std::optional<Drawing> here = drawingOf(plane, slice);
      if (!here) continue;
      for (int n = last ? last->slice + 1 : slice; n < slice; ++n, filled = true) blend(plane, *last, *here, n);
      last = std::move(here);
    }
    return whole;
  });
  if (result && !filled)
    return fail("There are no empty slices between the drawn slices. Draw the shape on slices that are farther apart.");
  return result;
}

}  // namespace insonate
