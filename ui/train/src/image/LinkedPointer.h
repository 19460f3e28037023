#pragma once

#include "../model/CaseModel.h"
#include "../model/LiveModel.h"

#include <insonate/views/MprView.h>
#include <insonate/views/UltrasoundView.h>

#include <QObject>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::train {

/// Marks the point of the patient under the pointer in the other views, while the pointer is over the image or a CT
/// slice.
class LinkedPointer : public QObject {
 public:
  LinkedPointer(CaseModel& patientCase, LiveModel& live, views::UltrasoundView& picture, QWidget& canvas,
                QObject* parent);
  /// Adds a slice, which must outlive this object.
  void addSlice(views::MprView& slice, QWidget& canvas);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Slice {
    views::MprView* view;
    QWidget* canvas;
  };
  std::optional<Vec3> placeAt(QObject* canvas, views::DisplayPoint at) const;
  void mark(QObject* from, std::optional<Vec3> patient_mm);

  CaseModel& patientCase_;
  LiveModel& live_;
  views::UltrasoundView& picture_;
  QWidget& canvas_;
  std::vector<Slice> slices_;
};

}  // namespace insonate::train
