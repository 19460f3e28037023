#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::train {

class LevelControl;

/// In the panel, before an attempt: which level it counts for and what it takes, or that one practices freely.
class LevelCard final : public QWidget {
  Q_OBJECT

 public:
  explicit LevelCard(LevelControl& levels, QWidget* parent = nullptr);

 Q_SIGNALS:
  void courseWanted();

 private:
  void refresh();

  LevelControl& levels_;
  QLabel *title_, *rule_;
  QPushButton *open_, *free_;
};

}  // namespace insonate::train
