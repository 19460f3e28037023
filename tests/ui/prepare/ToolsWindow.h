#pragma once

#include "PrepareWindow.h"

namespace insonate::prepare {

/// Tools as a user has them: keys, the mouse on a slice, buttons.
class Tools : public PrepareWindow {
 protected:
  void SetUp() override {
    PrepareWindow::SetUp();
    openCase();
    shared_->structures.select(kVein);
    shared_->crosshair.moveTo({0, 12, 0});
    QApplication::processEvents();
  }
  QPoint pointOf(Vec3 patient_mm) {
    const double ratio = canvas("Axial slice")->devicePixelRatioF();
    const auto at = axial().displayFromPatient(patient_mm);
    return {int(at.x / ratio), int(at.y / ratio)};
  }
  /// The place that the middle of that pixel has.
  Vec3 placeOf(Vec3 patient_mm) {
    const double ratio = canvas("Axial slice")->devicePixelRatioF();
    const QPoint at = pointOf(patient_mm);
    return axial().patientFromDisplay({(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio});
  }
  void click(Vec3 patient_mm, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(canvas("Axial slice"), button, {}, pointOf(patient_mm));
  }
  void drag(Vec3 from_mm, Vec3 to_mm) {
    QTest::mousePress(canvas("Axial slice"), Qt::LeftButton, {}, pointOf(from_mm));
    QMouseEvent move(QEvent::MouseMove, pointOf(to_mm), Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(canvas("Axial slice"), &move);
    QTest::mouseRelease(canvas("Axial slice"), Qt::LeftButton, {}, pointOf(to_mm));
  }
  const LabelMap& labels() const { return shared_->labeling.labels(); }
  bool done() {
    return QTest::qWaitFor([&] { return !shared_->labeling.isBusy(); }, kPatience_ms);
  }
  std::size_t count(std::uint8_t label) const { return std::size_t(std::ranges::count(labels().voxels, label)); }
};

}  // namespace insonate::prepare
