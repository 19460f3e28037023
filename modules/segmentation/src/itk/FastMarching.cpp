#include "Guarded.h"
#include "ItkRun.h"
#include "tools/Gradient.h"

#include <insonate/segmentation/FastMarching.h>

#include <itkFastMarchingImageFilter.h>

namespace insonate {
namespace {

using Image = itk::Image<float, 3>;
using Marching = itk::FastMarchingImageFilter<Image, Image>;

Marching::NodeContainer::Pointer nodesAt(const VolumeGeometry& part, std::span<const Vec3> seeds_mm) {
  auto nodes = Marching::NodeContainer::New();
  const Transform indexFromPatient = part.indexFromPatient();
  for (const Vec3& seed_mm : seeds_mm) {
    const auto [i, j, k] = nearestVoxel(indexFromPatient * seed_mm);
    if (!part.contains(i, j, k)) continue;
    Marching::NodeType node;
    node.SetValue(0);
    node.SetIndex({{i, j, k}});
    nodes->InsertElement(nodes->Size(), node);
  }
  return nodes;
}

}  // namespace

Result<Selection> fastMarching(const CtVolume& ct, const VoxelBox& box, std::span<const Vec3> seeds_mm,
                               const MarchingFront& front, const Progress& progress) {
  Selection reached(ct.geometry, box);
  const auto nodes = box.empty() ? Marching::NodeContainer::New() : nodesAt(reached.mask.geometry, seeds_mm);
  if (nodes->Size() == 0) return fail("No click lies in the region. Click on the structure.");
  return segmentation::guarded([&] {
    segmentation::Work work(progress, 4);
    work.start("Finding edges");
    Volume<float> speed = segmentation::gradientMagnitude(ct, box, front.smoothing_mm, work);
    for (float& value : speed.voxels) {
      const double steepness = value / front.edge_HUpmm;
      value = static_cast<float>(1 / (1 + steepness * steepness));
    }
    auto marching = Marching::New();
    marching->SetInput(segmentation::itkImageOver(speed));
    marching->SetTrialPoints(nodes);
    marching->SetStoppingValue(front.reach_mm);
    segmentation::run(*marching, progress, "Marching");
    const float* const arrival = marching->GetOutput()->GetBufferPointer();
    for (std::size_t v = 0; v < reached.mask.voxels.size(); ++v)
      reached.mask.voxels[v] = arrival[v] <= static_cast<float>(front.reach_mm);
    return reached;
  });
}

}  // namespace insonate
