#pragma once

#include <insonate/views/SceneView.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkColorTransferFunction;
class vtkGPUVolumeRayCastMapper;
class vtkPiecewiseFunction;
class vtkVolume;

namespace insonate::views {

/// The CT itself, ray cast. Costs nothing while it is not visible.
class CtVolumeActor {
 public:
  explicit CtVolumeActor(vtkRenderer& renderer);
  ~CtVolumeActor();

  void setCase(const VtkCase* patient);
  void setVisible(bool visible);
  void setTransferFunction(const TransferFunction& function);
  /// Fewer rays and samples: while the scene moves, and always somewhat fewer where the processor draws.
  void setCoarse(bool coarse);
  void setSoftware(bool software);
  /// Of the view.
  void setPixels(double pixels);
  void setClipping(const std::optional<ClippingPlane>& plane);
  bool shown() const { return shown_; }

 private:
  void show();
  void setSampling();

  vtkRenderer& renderer_;
  vtkNew<vtkVolume> volume_;
  vtkNew<vtkPiecewiseFunction> opacity_;
  vtkNew<vtkColorTransferFunction> colour_;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper_;
  bool hasCase_ = false, visible_ = false, shown_ = false, coarse_ = false, software_ = false;
  double pixels_ = 1;
};

}  // namespace insonate::views
