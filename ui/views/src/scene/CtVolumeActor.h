#pragma once

#include "../cast/CastProp.h"

#include <insonate/views/SceneView.h>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkColorTransferFunction;
class vtkGPUVolumeRayCastMapper;
class vtkPiecewiseFunction;
class vtkVolume;

namespace insonate::views {

/// The CT as a volume, drawn by ray casting on the graphics card or, without one, by CastProp. Uses no computing time
/// while it is not visible.
class CtVolumeActor {
 public:
  explicit CtVolumeActor(vtkRenderer& renderer);
  ~CtVolumeActor();

  void setCase(const std::shared_ptr<const VtkCase>& patient);
  void setVisible(bool visible);
  void setTransferFunction(const TransferFunction& function);
  /// Sets whether fewer rays and samples are used, for a moving scene.
  void setCoarse(bool coarse);
  /// Sets whether the CT is drawn on the processor because there is no graphics card.
  void setSoftware(bool software);
  /// Sets a listener that is called on other threads when a better image can be drawn.
  void setNews(std::function<void()> news) { cast_->setNews(std::move(news)); }
  /// Tells whether the last frame was complete.
  bool exact() const { return !shown_ || !software_ || cast_->exact(); }
  /// Tells whether a new frame would be more complete.
  bool hasNews() const { return shown_ && software_ && cast_->hasNews(); }
  void setClipping(const std::optional<ClippingPlane>& plane);
  bool shown() const { return shown_; }

 private:
  void show();
  void setSampling();

  vtkRenderer& renderer_;
  vtkNew<vtkVolume> volume_;
  vtkNew<vtkPiecewiseFunction> opacity_;
  vtkNew<vtkColorTransferFunction> color_;
  vtkSmartPointer<vtkGPUVolumeRayCastMapper> mapper_;
  vtkNew<CastProp> cast_;
  vtkProp* drawn_ = nullptr;  ///< the prop that was added to the renderer
  bool hasCase_ = false, visible_ = false, shown_ = false, coarse_ = false, software_ = false;
};

}  // namespace insonate::views
