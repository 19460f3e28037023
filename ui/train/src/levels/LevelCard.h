#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::train {

class LevelControl;
class TestAdmissions;

/// Card in the attempt panel that shows the next attempt's level and its rule, or that practice is free.
class LevelCard final : public QWidget {
  Q_OBJECT

 public:
  LevelCard(LevelControl& levels, TestAdmissions& admissions, const QString& showLevels, QWidget* parent = nullptr);

 Q_SIGNALS:
  void courseWanted();

 private:
  void refresh();

  LevelControl& levels_;
  TestAdmissions& admissions_;
  QLabel *title_, *rule_, *test_;
  QPushButton *open_, *free_, *code_;
};

}  // namespace insonate::train
