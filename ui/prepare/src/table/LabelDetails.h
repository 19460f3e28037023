#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace insonate::prepare {

class PrepareSession;

/// Details of the selected structure: state, tissue, term and voxels, in words.
class LabelDetails : public QWidget {
 public:
  explicit LabelDetails(PrepareSession& session, QWidget* parent = nullptr);

 private:
  void refresh();

  PrepareSession& session_;
  QComboBox *state_, *tissue_;
  QLabel* term_;
};

}  // namespace insonate::prepare
