#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

class ClassController;
class OpeningDialog;

/// Line on the page of a class that states which tests are open, with a button that opens and closes tests.
class OpeningBar final : public QWidget {
  Q_OBJECT

 public:
  OpeningBar(ClassController& controller, ui::Commands& commands, QWidget* parent = nullptr);

 private:
  void refresh();
  void showDialog();

  ClassController& controller_;
  QLabel* words_;
  QPushButton* tests_;
  QElapsedTimer sinceRead_;  ///< time since the class was read
  QTimer again_;             ///< updates the text, since openings begin and end without a query
};

}  // namespace insonate::review
