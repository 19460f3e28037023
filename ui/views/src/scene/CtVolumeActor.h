#pragma once

#include <insonate/views/SceneView.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkGPUVolumeRayCastMapper;
class vtkVolume;

namespace insonate::views {

/// The CT itself, ray cast. Costs nothing while its look is Off.
class CtVolumeActor {
 public:
  explicit CtVolumeActor(vtkRenderer& renderer);
  ~CtVolumeActor();

  void set(const VtkCase* patient, CtLook look);
  /// Fewer rays and samples: while the scene moves, and always somewhat fewer where the processor draws.
  void setCoarse(bool coarse);
  void setSoftware(bool software);
  void setClipping(const std::optional<ClippingPlane>& plane);
  bool shown() const { return shown_; }

 private:
  void setSampling();

  vtkRenderer& renderer_;
  vtkNew<vtkVolume> volume_;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper_;
  bool shown_ = false, coarse_ = false, software_ = false;
};

}  // namespace insonate::views
