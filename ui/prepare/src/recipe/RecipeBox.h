#pragma once

#include "../labels/StepReplay.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace insonate::prepare {

struct PrepareModel;

/// Saves the labeling steps since the case was opened as a recipe, and replays a recipe. A replay runs its steps one by
/// one as long jobs that can be cancelled. Either all steps are applied or none.
class RecipeBox : public QWidget {
 public:
  explicit RecipeBox(PrepareModel& shared, QWidget* parent = nullptr);

 private:
  void refresh();
  void askSave();
  void askReplay();
  void save(const QString& file);
  void replay(const QString& file);

  PrepareModel& shared_;
  StepReplay replay_;
  QLabel* none_;
  QListWidget* steps_;
  QPushButton *save_, *load_;
};

}  // namespace insonate::prepare
