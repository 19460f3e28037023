#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/views/MprView.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <memory>

namespace insonate::ui {
class ViewWidget;
}
class QWidget;

namespace insonate::train {

class CaseModel;
class LiveModel;

/// Shows the CT beside the ultrasound image: the same plane at the same scale, limited to the field of view, with
/// outlines of the structures. The CT follows the image on display at a rate that does not slow live images.
class CtBeside : public QObject {
 public:
  CtBeside(CaseModel& patientCase, LiveModel& live, QWidget* parent);

  ui::ViewWidget& widget() { return *widget_; }
  views::MprView& view() { return *view_; }
  void setShown(bool shown);
  bool isShown() const { return shown_; }

 private:
  void showCase();
  void want();
  void follow();

  CaseModel& patientCase_;
  LiveModel& live_;
  std::shared_ptr<views::MprView> view_;
  ui::ViewWidget* widget_;
  std::shared_ptr<const ImagingSetup> shape_;
  bool shown_ = false;
  QTimer timer_;
  QElapsedTimer sinceFollowed_;
};

}  // namespace insonate::train
