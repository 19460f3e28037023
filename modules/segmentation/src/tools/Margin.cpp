#include "Guarded.h"
#include "Morphology.h"

#include <insonate/segmentation/Margin.h>

namespace insonate {
namespace {

using segmentation::Mask;
using segmentation::Work;

template <class Change>
Result<Selection> changed(const Selection& shape, const Progress& progress, const Change& change) {
  if (shape.box.empty()) return shape;
  auto result = segmentation::guarded([&] {
    Work work(progress, 8);
    work.start("Moving the surface");
    Selection other = shape;
    change(other.mask, work);
    return other;
  });
  if (result && result->count() == 0 && shape.count() > 0)
    return fail(
        "Nothing of the label would be left, since it is thinner than this distance everywhere. Use a smaller "
        "distance.");
  return result;
}

}  // namespace

Result<Selection> grownBy(const Selection& shape, double margin_mm, const Progress& progress) {
  return changed(shape, progress, [&](Mask& mask, Work& work) { segmentation::dilate(mask, margin_mm, work); });
}

Result<Selection> shrunkBy(const Selection& shape, double margin_mm, const Progress& progress) {
  return changed(shape, progress, [&](Mask& mask, Work& work) { segmentation::erode(mask, margin_mm, work); });
}

Result<Selection> makeShell(const Selection& shape, double thickness_mm, Wall wall, const Progress& progress) {
  const double outside_mm = wall == Wall::kOutside ? thickness_mm : wall == Wall::kMiddle ? thickness_mm / 2 : 0;
  return changed(shape, progress, [&](Mask& mask, Work& work) {
    Mask inner = mask;
    if (outside_mm < thickness_mm) segmentation::erode(inner, thickness_mm - outside_mm, work);
    if (outside_mm > 0) segmentation::dilate(mask, outside_mm, work);
    work.voxels(mask.geometry, [&](std::size_t v) { mask.voxels[v] &= std::uint8_t(inner.voxels[v] ^ 1); });
  });
}

}  // namespace insonate
