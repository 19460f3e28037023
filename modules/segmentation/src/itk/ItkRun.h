#pragma once

#include "Work.h"

#include <insonate/image/Volume.h>

#include <itkCommand.h>
#include <itkImage.h>
#include <itkProcessObject.h>

#include <new>

namespace insonate::segmentation {

/// Returns an ITK image that uses a volume's voxels; the volume must outlive it. The image has the volume's spacing,
/// but not its position and direction: filters work in millimeters along the grid's own axes, of either handedness.
template <class T>
typename itk::Image<T, 3>::Pointer itkImageOver(Volume<T>& volume) {
  using Image = itk::Image<T, 3>;
  const VolumeGeometry& g = volume.geometry;
  auto image = Image::New();
  typename Image::SizeType size;
  typename Image::SpacingType spacing;
  for (unsigned axis = 0; axis < 3; ++axis) {
    size[axis] = itk::SizeValueType(g.size[axis]);
    spacing[axis] = g.spacing_mm[int(axis)];
  }
  image->SetRegions(size);
  image->SetSpacing(spacing);
  image->GetPixelContainer()->SetImportPointer(volume.voxels.data(), volume.voxels.size(), false);
  return image;
}

/// Runs a filter. If the Progress callback cancels, stops the filter and throws Cancelled.
template <class Filter>
void run(Filter& filter, const Progress& progress, std::string_view doing) {
  const auto tell = [&](itk::Object*, const itk::EventObject&) {
    if (!report(progress, doing, std::min<double>(filter.GetProgress(), 0.99))) filter.AbortGenerateDataOn();
  };
  filter.AddObserver(itk::ProgressEvent(), [&](const itk::EventObject& event) { tell(&filter, event); });
  filter.AddObserver(itk::IterationEvent(), [&](const itk::EventObject& event) { tell(&filter, event); });
  try {
    filter.Update();
  } catch (const itk::ProcessAborted&) {
    throw Cancelled{};
  } catch (const itk::MemoryAllocationError&) {
    throw std::bad_alloc{};
  }
}

}  // namespace insonate::segmentation
