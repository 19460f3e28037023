#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace insonate::prepare {

class PrepareSession;

/// Difficulty of the case: as computed from its labels, with the measures behind it, and as its author states it.
class DifficultyBox : public QWidget {
 public:
  explicit DifficultyBox(PrepareSession& session, QWidget* parent = nullptr);

 private:
  void refresh();

  PrepareSession& session_;
  QComboBox* grade_;
  QLabel *sentence_, *measures_;
};

}  // namespace insonate::prepare
