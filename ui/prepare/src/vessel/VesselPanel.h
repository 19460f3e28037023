#pragma once

#include <QWidget>

class QLabel;

namespace insonate::prepare {

struct PrepareModel;
class SectionStrip;
class StraightView;
class VesselSession;

/// The selected vessel: straightened at the top, its cross-sections below, or a sentence if there is no vessel. Wheel
/// and arrow keys move along the vessel; with Shift, they rotate the straightened view.
class VesselPanel : public QWidget {
 public:
  VesselPanel(PrepareModel& shared, VesselSession& vessel);

 protected:
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void showCourse();
  void showHeading();

  PrepareModel& shared_;
  VesselSession& vessel_;
  QLabel *heading_, *reason_;
  StraightView* straight_;
  SectionStrip* sections_;
};

}  // namespace insonate::prepare
