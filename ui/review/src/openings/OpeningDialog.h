#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/OpeningStore.h>

#include <QDialog>
#include <QString>
#include <functional>
#include <map>
#include <string>

class QCheckBox;
class QComboBox;
class QDateTimeEdit;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate {
class SignedIn;
}

namespace insonate::review {

class ClassController;

/// Dialog in which an instructor opens tests of a class, sees all openings, and closes them. An administrator can also
/// open a test for everyone.
class OpeningDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit OpeningDialog(ClassController& controller, QWidget* parent = nullptr);

 private:
  QWidget* buildTable();
  QWidget* buildForm();
  QWidget* buildButtons();
  void refresh();
  void showChosen();
  const TestOpening* chosen() const;
  NewOpening entered() const;
  /// The open or waiting opening of the entered test during the entered time; null if there is none.
  const TestOpening* sameOpening(const NewOpening& opening) const;
  void readReadiness();
  void showReadiness();
  void edited();
  bool mayOpen() const;
  void openTest();
  void askAgain(const TestOpening& open);
  void closeTest();
  void change(std::function<Result<std::string>(const SignedIn&)> change, const QString& done,
              const QString& code = {});

  ClassController& controller_;
  const std::string cohort_;  ///< id of the class that was shown when the dialog was opened
  QTableWidget* openings_;
  QComboBox *test_, *whom_;
  QDateTimeEdit *start_, *end_;
  QCheckBox* ends_;
  QLineEdit* code_;
  QPushButton *open_, *close_;
  bool isCloseAsked_ = false;  ///< true: the next press of close_ closes the selected test
  QLabel *ready_, *said_;
  std::map<std::string, int> readiness_;  ///< testReadiness() when the dialog was opened
  bool isAsked_ = false;                  ///< the user was warned that the entered test is open already
};

}  // namespace insonate::review
