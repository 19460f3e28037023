#pragma once

#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::train {

class LevelControl;
class TestAdmissions;

/// Card in the attempt panel that shows the level of the next attempt and the level's rule, or that the attempt is free
/// practice.
class LevelCard final : public QWidget {
  Q_OBJECT

 public:
  LevelCard(LevelControl& levels, TestAdmissions& admissions, const QString& showLevels, QWidget* parent = nullptr);

 Q_SIGNALS:
  void courseRequested();

 private:
  void refresh();

  LevelControl& levels_;
  TestAdmissions& admissions_;
  QLabel *title_, *rule_, *test_;
  QPushButton *open_, *free_, *code_;
};

}  // namespace insonate::train
