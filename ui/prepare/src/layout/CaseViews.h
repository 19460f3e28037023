#pragma once

#include "../labels/PreviewSurface.h"

#include <insonate/surface/Mesh.h>
#include <insonate/views/MprView.h>
#include <insonate/views/SceneView.h>

#include <QPoint>
#include <QTimer>
#include <QWidget>
#include <array>
#include <functional>
#include <memory>
#include <vector>

class QLabel;
class QSplitter;
class QStackedWidget;

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::prepare {

struct PrepareModel;

/// Four views of the patient: axial, coronal and sagittal slices with a common crosshair, and a 3D view with the probe.
/// A click on a structure in 3D moves the crosshair to the clicked point.
class CaseViews : public QWidget {
 public:
  static constexpr int kSlices = 3;

  explicit CaseViews(PrepareModel& shared, QWidget* parent = nullptr);
  ~CaseViews() override;

  const std::shared_ptr<views::SceneView>& sharedScene() { return scene_; }
  views::MprView& slice(int index) { return *slices_[std::size_t(index)]; }
  /// Widgets of the slices, followed by the widget of the 3D view.
  const std::array<ui::ViewWidget*, kSlices + 1>& widgets() const { return widgets_; }
  const PreviewSurface& previewSurface() const { return previewSurface_; }
  /// Tells whether the 3D view is up to date and in full detail.
  bool isAtRest() const { return !follow_.isActive() && !rest_.isActive(); }
  void setRested(std::function<void()> listener) { rested_ = std::move(listener); }

  /// Sets a line to draw over 3D.
  void setSceneLine(std::vector<Vec3> line_mm);
  /// Sets clicked points, shown as numbers in slices and as crosses in 3D.
  void setClicks(const std::vector<Vec3>& clicks_mm);

  /// Sets a panel that can take the place of the sagittal slice and the 3D view.
  void setLowerPanel(QWidget* panel);
  void showLowerPanel(bool isShown);

  QByteArray saveState() const;
  void restoreState(const QByteArray& state);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();
  void connectSlices();
  void showCase();
  /// Replaces the case by its saved state, which has the same voxels at another address.
  void replaceCase();
  void showSeen();
  void showLook(int label);
  void showSlices();
  void showCrosshair();
  void showSurface(int label, const Mesh& mesh);
  void showPreview(const Mesh* mesh);
  void showPlaces();
  void followProbe();
  void placeCamera();
  void buildEmpty();
  /// Tells whether the case is known to have no labels.
  bool isUnlabeled() const;
  void pickAt(QPoint at);

  PrepareModel& shared_;
  PreviewSurface previewSurface_;
  std::uint8_t faded_ = 0;  ///< label that is drawn fainter beside its preview; 0: none
  std::vector<Vec3> sceneLine_mm_, clicks_mm_;
  std::shared_ptr<views::VtkCase> case_;
  std::array<std::shared_ptr<views::MprView>, kSlices> slices_;
  std::shared_ptr<views::SceneView> scene_;
  std::array<ui::ViewWidget*, kSlices + 1> widgets_{};
  QSplitter* rows_ = nullptr;
  QStackedWidget* lower_ = nullptr;  ///< the lower row of views, and the panel in its place
  QLabel* empty_ = nullptr;          ///< text that the 3D view shows while there is nothing else to show
  std::array<QSplitter*, 2> columns_{};
  QTimer follow_, rest_;
  std::function<void()> rested_;
  Transform pose_;
  QPoint pressed_;
  bool click_ = false, cameraPlaced_ = false;
};

}  // namespace insonate::prepare
