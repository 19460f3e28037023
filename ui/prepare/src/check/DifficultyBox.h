#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace insonate::prepare {

struct PrepareModel;

/// Shows the case's difficulty as computed from its labels, with the measured values from which the difficulty was
/// computed. The author can set a grade.
class DifficultyBox : public QWidget {
 public:
  explicit DifficultyBox(PrepareModel& shared, QWidget* parent = nullptr);

 private:
  void refresh();

  PrepareModel& shared_;
  QComboBox* grade_;
  QLabel *sentence_, *measures_;
};

}  // namespace insonate::prepare
