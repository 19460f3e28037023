#include "Guarded.h"
#include "ItkRun.h"
#include "tools/Gradient.h"

#include <insonate/segmentation/LevelSet.h>

#include <itkGeodesicActiveContourLevelSetImageFilter.h>

#include <algorithm>

namespace insonate {
namespace {

using Image = itk::Image<float, 3>;

/// Checks for cancellation also between the steps of the preparation, which report no progress.
class Contour final : public itk::GeodesicActiveContourLevelSetImageFilter<Image, Image> {
 public:
  using Self = Contour;
  using Base = itk::GeodesicActiveContourLevelSetImageFilter<Image, Image>;
  using Pointer = itk::SmartPointer<Self>;
  itkFactorylessNewMacro(Self);

 protected:
  Contour() { AutoGenerateSpeedAdvectionOff(); }
  void GenerateData() override {
    GenerateSpeedImage();
    ask();
    if (GetAdvectionScaling() != 0) GenerateAdvectionImage();
    ask();
    Base::GenerateData();
  }
  void CopyInputToOutput() override {
    Base::CopyInputToOutput();
    ask();
  }
  void Initialize() override {
    Base::Initialize();
    ask();
  }

 private:
  void ask() {
    InvokeEvent(itk::ProgressEvent());
    if (GetAbortGenerateData()) throw itk::ProcessAborted(__FILE__, __LINE__);
  }
};

/// Root mean square change of a round below which the surface has converged.
constexpr double kRest = 0.005;

}  // namespace

Result<Selection> levelSet(const CtVolume& ct, const Selection& start, const GeodesicLevelSet& parameters,
                           const Progress& progress) {
  if (start.count() == 0)
    return fail("The label is empty, so its surface cannot move. Paint or grow a part of the label first.");
  return segmentation::guarded([&] {
    segmentation::Work work(progress, 4);
    work.start("Finding edges");
    Volume<float> edges = segmentation::gradientMagnitude(ct, start.box, parameters.smoothing_mm, work);
    for (float& value : edges.voxels) {
      const double steepness = value / parameters.edge_HUpmm;
      value = static_cast<float>(1 / (1 + steepness * steepness));
    }
    Volume<float> inside(start.mask.geometry);
    std::ranges::transform(start.mask.voxels, inside.voxels.begin(),
                           [](std::uint8_t chosen) { return chosen ? -0.5F : 0.5F; });
    auto contour = Contour::New();
    contour->SetInput(segmentation::itkImageOver(inside));
    contour->SetFeatureImage(segmentation::itkImageOver(edges));
    contour->SetPropagationScaling(static_cast<float>(parameters.propagation));
    contour->SetCurvatureScaling(static_cast<float>(parameters.curvature));
    contour->SetAdvectionScaling(static_cast<float>(parameters.advection));
    // The edges are already computed from a blurred CT.
    contour->SetDerivativeSigma(0);
    contour->SetMaximumRMSError(kRest);
    contour->SetNumberOfIterations(itk::IdentifierType(parameters.rounds));
    segmentation::run(*contour, progress, "Moving the surface");
    Selection enclosed(ct.geometry, start.box);
    const float* const result = contour->GetOutput()->GetBufferPointer();
    for (std::size_t v = 0; v < enclosed.mask.voxels.size(); ++v) enclosed.mask.voxels[v] = result[v] < 0;
    return enclosed;
  });
}

}  // namespace insonate
