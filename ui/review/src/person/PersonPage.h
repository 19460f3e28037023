#pragma once

#include <QPushButton>
#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;

namespace insonate::ui {
class Chart;
class Commands;
}  // namespace insonate::ui

namespace insonate::review {

class ClassController;
class HistoryTable;
class PersonController;

/// Page about one person: present level with the reason, learning curves, and attempts.
class PersonPage final : public QWidget {
  Q_OBJECT

 public:
  PersonPage(PersonController& controller, const ClassController& room, ui::Commands& commands,
             QWidget* parent = nullptr);

  /// Sets the menu that saves the person's data; a button opens it.
  void setSaving(QMenu* menu) { save_->setMenu(menu); }
  void openSaving() {
    if (save_->isEnabled()) save_->showMenu();
  }

 Q_SIGNALS:
  /// Emitted when the user wants to replay the recording of an attempt of the store.
  void replayRequested(const QString& file, const QString& attempt);
  /// Emitted when the user wants to see another person of the class (Person::id).
  void personRequested(const QString& person);
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 private:
  QWidget* buildHead(const ui::Commands& commands);
  QWidget* buildCharts();
  void addSteps(ui::Commands& commands);
  void step(int by);
  QComboBox* choice(const char* name, const QString& title, const QString& tip);
  void showPerson();
  void showWhere();
  void fillLevels();
  void showCharts();

  PersonController& controller_;
  const ClassController& room_;
  QLabel *name_, *sentence_;
  QPushButton *save_, *previous_, *next_;
  QComboBox *metric_, *level_;
  ui::Chart *learning_, *cusum_, *place_;
  HistoryTable* history_;
};

}  // namespace insonate::review
