#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::train {

class LevelControl;

/// The level before an attempt, with its rule, or free practice; in the panel.
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
