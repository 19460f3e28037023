#pragma once

#include <insonate/views/MprView.h>

#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <optional>

namespace insonate {
struct ImagingSetup;
}
namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

/// Four CT slices with one crosshair: the probe's plane, axial, coronal and sagittal.
class FourSlices : public QWidget {
 public:
  explicit FourSlices(QWidget* parent = nullptr);
  ~FourSlices() override;

  /// Sets the case. At the next follow() the crosshair moves to the probe.
  void setCase(const std::shared_ptr<views::VtkCase>& patient);
  /// Sets the first slice to the probe's image plane. If the probe has moved, the crosshair moves to the center of the
  /// image.
  void follow(const std::shared_ptr<const ImagingSetup>& setup, const Transform& patientFromProbe);
  void setWindowLevel(views::WindowLevel value);
  /// Draws paths, such as a wire, where they are near a slice.
  void setPaths(const std::vector<views::ScenePath>& paths);
  /// Sets a listener that is called when the user changes window or level.
  void setWindowChanged(const std::function<void(views::WindowLevel)>& listener);
  void setLabelOpacity(double opacity);
  void setLabelColor(std::uint8_t label, views::Color color);
  /// Returns the sum of the durations of the last rendering of each slice.
  double renderTime_s() const;

  static constexpr std::size_t kCount = 4;
  views::MprView& slice(std::size_t n) { return *slices_[n]; }
  ui::ViewWidget& widget(std::size_t n) { return *widgets_[n]; }

 private:
  void setCrosshair(Vec3 position_mm);

  std::array<std::shared_ptr<views::MprView>, kCount> slices_;
  std::array<ui::ViewWidget*, kCount> widgets_{};
  std::shared_ptr<const ImagingSetup> shape_;  ///< setup of the probe whose outline is drawn
  std::optional<Transform> pose_;
};

}  // namespace insonate::train
