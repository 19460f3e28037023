#pragma once

#include <QWidget>

class QBoxLayout;
class QHBoxLayout;
class QLabel;

namespace insonate::ui {
class Commands;
}

namespace insonate::train {

class AttemptControl;
class SyringeView;
class CaseModel;
class DisclosureModel;
class HapticControl;

/// The line under the image during an attempt: time, five metrics, needle and syringe. In test mode the line shows only
/// what an operator would notice without the simulator.
class AttemptStrip final : public QWidget {
 public:
  AttemptStrip(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase, AttemptControl& attempt,
               const ui::Commands& commands, QWidget* parent = nullptr);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QLabel* number(const char* object, const QString& widest, const QString& says);
  void refresh();
  void refreshNeedle();

  DisclosureModel& disclosure_;
  HapticControl& hands_;
  CaseModel& patientCase_;
  AttemptControl& attempt_;
  const ui::Commands& commands_;
  QBoxLayout* rows_;
  QHBoxLayout* row_;  ///< row to which widgets are added
  QLabel *time_, *vein_, *artery_, *double_, *toVein_, *used_, *needle_, *drawn_;
  SyringeView* syringe_;
};

}  // namespace insonate::train
