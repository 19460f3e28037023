#pragma once

#include "../guide/GuideReplay.h"

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace insonate::prepare {

struct PrepareModel;

/// The steps of labelling since the case was opened, saved as a recipe, and a recipe replayed: step by step, as long
/// jobs that can be cancelled, all of it or nothing.
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
  GuideReplay replay_;
  QLabel* none_;
  QListWidget* steps_;
  QPushButton *save_, *load_;
};

}  // namespace insonate::prepare
