#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::train {

class LevelControl;

/// Card in the attempt panel that shows the next attempt's level and its rule, or that practice is free.
class LevelCard final : public QWidget {
  Q_OBJECT

 public:
  explicit LevelCard(LevelControl& levels, const QString& showLevels, QWidget* parent = nullptr);

 Q_SIGNALS:
  void courseWanted();

 private:
  void refresh();

  LevelControl& levels_;
  QLabel *title_, *rule_;
  QPushButton *open_, *free_;
};

}  // namespace insonate::train
