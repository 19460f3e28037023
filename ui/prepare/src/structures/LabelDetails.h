#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace insonate::prepare {

struct PrepareModel;

/// Shows state, tissue, term and number of voxels of the selected structure, in words.
class LabelDetails : public QWidget {
 public:
  explicit LabelDetails(PrepareModel& shared, QWidget* parent = nullptr);

 private:
  void refresh();

  PrepareModel& shared_;
  QComboBox *state_, *tissue_;
  QLabel* term_;
};

}  // namespace insonate::prepare
