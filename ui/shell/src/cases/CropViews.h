#pragma once

#include <insonate/cases/PatientCase.h>

#include <QImage>
#include <QWidget>
#include <array>
#include <memory>
#include <optional>

namespace insonate::ui {

/// A box in patient LPS, mm, along the axes of the patient.
struct PatientBox {
  Vec3 low_mm, high_mm;

  friend bool operator==(const PatientBox&, const PatientBox&) = default;
};

/// An axial, a coronal and a sagittal slice through the middle of a box, at one scale. The user drags the borders and
/// the corners of the box, or the whole box.
class CropViews : public QWidget {
  Q_OBJECT

 public:
  /// `limits` is the part of the patient that the slices show.
  CropViews(std::shared_ptr<const PatientCase> patient, const PatientBox& limits, QWidget* parent = nullptr);

  const PatientBox& box() const { return box_; }
  /// Sets the box without boxChanged().
  void setBox(const PatientBox& box);
  /// Returns the place of a point of the patient in the axial (0), coronal (1) or sagittal (2) slice.
  QPointF placeOf(int view, Vec3 patient_mm) const;

  QSize sizeHint() const override;

 Q_SIGNALS:
  /// Emitted while the user drags.
  void boxChanged();

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  static constexpr int kViews = 3;

  /// The borders of a view's box that a drag moves: -1 the lower one, 1 the upper one, 0 none, of both axes; all zero:
  /// the whole box.
  struct Grip {
    int view = 0, across = 0, down = 0;
  };

  QRectF frameOf(int view) const;
  QRectF boxIn(int view) const;
  double scale_pxpmm() const;
  std::optional<Grip> gripAt(QPointF at) const;
  void moveTo(QPointF at);
  void showCursor(const std::optional<Grip>& grip);
  void drawSlices();
  QImage drawnSlice(int view) const;

  std::shared_ptr<const PatientCase> patient_;
  PatientBox limits_, box_;
  std::array<QImage, kViews> slices_;
  std::optional<Grip> grip_;
  QPointF from_;       ///< place at which the drag began
  PatientBox before_;  ///< box when the drag began
};

}  // namespace insonate::ui
