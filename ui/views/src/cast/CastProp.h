#pragma once

#include "Refiner.h"

#include <insonate/views/VtkCase.h>

#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <functional>
#include <memory>

class vtkRayCastImageDisplayHelper;
class vtkRenderer;

namespace insonate::views {

/// Draws the CT by ray casting on the processor, combined with the other objects of the scene. A frame is drawn at once
/// with as many rays as the time permits; a Refiner then casts all rays for a later frame. Uses no computing time while
/// it is not visible.
class CastProp : public vtkProp {
 public:
  static CastProp* New();
  vtkTypeMacro(CastProp, vtkProp)

      /// Sets a listener that is called on other threads when a better image can be drawn.
      void setNews(std::function<void()> news) {
    news_ = std::move(news);
  }
  /// Sets the case; null: no case.
  void setCase(const std::shared_ptr<const VtkCase>& patient);
  void setTransferFunction(const TransferFunction& function);
  void setClipping(const std::optional<ClippingPlane>& plane) { clipping_ = plane; }
  /// Sets whether the scene moves; images are refined only at rest.
  void setMoving(bool moving);
  /// Tells whether all rays were cast for the last frame.
  bool exact() const { return exact_; }

  /// Tells whether a better image has become ready since the last frame.
  bool hasNews() const { return fresh_; }

  /// Returns the distance between rays, in pixels along each axis, for an image with the number of pixels `pixels` if
  /// one ray takes `perRay_ms`.
  static double spacingFor(double pixels, double perRay_ms);

  double* GetBounds() override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  CastProp();
  ~CastProp() override;

 private:
  bool ready();
  void aim(vtkRenderer& renderer, int x, int y);
  void castQuickly();
  void show(vtkRenderer& renderer, const CastTask& task, const std::vector<std::uint8_t>& rgba);

  std::function<void()> news_;
  std::shared_ptr<const VtkCase> case_;
  TransferFunction transfer_;
  std::optional<ClippingPlane> clipping_;
  std::unique_ptr<Refiner> refiner_;
  CastTask quick_;  ///< the task of the present frame; its look is null until the CT is prepared
  std::vector<std::uint8_t> rgba_;
  vtkSmartPointer<vtkRayCastImageDisplayHelper> display_;
  double perRay_ms_ = 1e-3;
  double box_[6] = {};
  bool moving_ = false, exact_ = false;
  std::atomic<bool> fresh_{false};
};

}  // namespace insonate::views
