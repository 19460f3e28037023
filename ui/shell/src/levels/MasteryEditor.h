#pragma once

#include "LevelControls.h"

#include <insonate/curriculum/LcCusum.h>

#include <QWidget>
#include <string>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace insonate::ui {

class TaskBar;

/// Editor of the rules for mastery and lapse: consecutive passes, LC-CUSUM with a limit calibrated by simulation, days
/// without practice, failures.
class MasteryEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit MasteryEditor(QWidget* parent = nullptr);

  void show(const Level& level);
  using QWidget::show;

 Q_SIGNALS:
  void edited(const QString& field, const insonate::ui::LevelEdit& change);

 private:
  QWidget* buildRow();
  QWidget* buildCusum();
  QWidget* buildCalibration();
  QWidget* buildLapses();
  void findLimit();
  void applyCusum();
  void applyLapses();

  QSpinBox *passes_, *trials_, *days_, *failures_, *within_;
  QCheckBox *cusum_, *byDays_, *byFailures_;
  QDoubleSpinBox *acceptable_, *unacceptable_, *limit_, *falseSignals_;
  QPushButton* calibrate_;
  QLabel *fewest_, *calibrated_;
  TaskBar* tasks_;
  std::string level_;  ///< Level::name of the level that is shown
  CusumRule rule_;     ///< the rule that was shown last
};

}  // namespace insonate::ui
