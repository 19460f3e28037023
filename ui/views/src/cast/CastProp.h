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

/// The CT drawn by the processor, over and behind what else the scene draws: at once with as many rays as there is time
/// for, then by a Refiner with all of them, which come with a later picture. Costs nothing while it is not visible.
class CastProp : public vtkProp {
 public:
  static CastProp* New();
  vtkTypeMacro(CastProp, vtkProp)

      /// `news` is called on other threads when a better image can be drawn.
      void setNews(std::function<void()> news) {
    news_ = std::move(news);
  }
  /// Sets the case; null for none.
  void setCase(const std::shared_ptr<const VtkCase>& patient);
  void setTransferFunction(const TransferFunction& function);
  void setClipping(const std::optional<ClippingPlane>& plane) { clipping_ = plane; }
  /// Sets whether the scene moves: then no image is refined.
  void setMoving(bool moving);
  /// Tells whether the last frame has all its rays.
  bool exact() const { return exact_; }

  /// Since then something has become ready.
  bool hasNews() const { return fresh_; }

  /// Distance of rays in pixels, along a side, for an image of this many pixels and this time per ray.
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
  CastTask quick_;  ///< what is drawn now; its look is null until it is made ready
  std::vector<std::uint8_t> rgba_;
  vtkSmartPointer<vtkRayCastImageDisplayHelper> display_;
  double perRay_ms_ = 1e-3;
  double box_[6] = {};
  bool moving_ = false, exact_ = false;
  std::atomic<bool> fresh_{false};
};

}  // namespace insonate::views
