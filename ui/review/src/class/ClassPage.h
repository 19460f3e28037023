#pragma once

#include <QPushButton>
#include <QWidget>

class QComboBox;
class QLabel;
class QMenu;
class QListWidget;
class QSortFilterProxyModel;
class QStackedWidget;
class QTableView;

namespace insonate {
struct Person;
}

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

class ClassController;
class ClassTable;

/// Overview of a class: choice of the class, each person's progress and performance, and people who need the
/// instructor's help.
class ClassPage final : public QWidget {
  Q_OBJECT

 public:
  ClassPage(ClassController& controller, ui::Commands& commands, QWidget* parent = nullptr);

  /// Person::id of the selected row; empty: none.
  QString chosenPerson() const;

  /// Sets the menu that saves the class's data; a button opens it.
  void setSaving(QMenu* menu) { save_->setMenu(menu); }
  void openSaving() {
    if (save_->isEnabled()) save_->showMenu();
  }

 Q_SIGNALS:
  void personChosen(const QString& person);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* buildHead(ui::Commands& commands);
  QWidget* buildTable();
  QWidget* buildConcerns();
  void showCohorts();
  void showClass();
  void showPlace();
  void showFacts();
  void showConcerns();
  void shareHeight();
  void addConcern(const Person& person, const QString& what, const QString& why);
  void announceChosenPerson();

  ClassController& controller_;
  ClassTable* model_;
  QSortFilterProxyModel* sorted_;
  QComboBox* cohorts_;
  QLabel *facts_, *words_, *concernsTitle_;
  QPushButton *save_, *again_;
  QTableView* table_;
  QListWidget* concerns_;
  QStackedWidget* center_;
};

}  // namespace insonate::review
