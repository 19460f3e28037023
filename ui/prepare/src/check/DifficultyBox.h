#pragma once

#include <QWidget>

class QComboBox;
class QLabel;

namespace insonate::prepare {

class PrepareSession;

/// How hard the case is: as its labels say, with the measures that say so, and as its author says.
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
