#pragma once

#include <insonate/curriculum/Form.h>
#include <insonate/ui/FormDraft.h>

#include <QTimer>
#include <QWidget>
#include <memory>
#include <utility>
#include <vector>

class QButtonGroup;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace insonate::ui {
class FormSheet;
}

namespace insonate::review {

class JudgingController;
class JudgementTable;

/// Checklists and ratings beside a replay: the user fills in forms, and reads submitted forms. Unfinished answers are
/// stored as a draft when the user moves in the replay, leaves the attempt, signs out or closes the window. The draft
/// is shown again later.
class JudgePane final : public QWidget {
  Q_OBJECT

 public:
  JudgePane(JudgingController& controller, const QString& draftFolder, QWidget* parent = nullptr);
  ~JudgePane() override;

 Q_SIGNALS:
  void statusMessage(const QString& sentence);

 protected:
  /// Ignores Backspace in a form, so that Backspace does not leave the attempt.
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum Page { kFill, kRead };

  QWidget* buildHead();
  QWidget* buildSheet();
  void addTab(QHBoxLayout& row, Page page, const char* object, const QString& text, const QString& tip);
  void showController();
  void showPage(int page);
  void showSheet();
  void showHandIn();
  void showProgress();
  void keepDraft();
  void askHandIn();
  void closeQuestion();
  void handIn();
  void handedIn();
  const Form& form() const;
  void chooseForm();
  /// Answers that the metrics of the attempt give; empty if the user may not judge it.
  FormAnswers proposal() const;

  JudgingController& controller_;
  const std::vector<Form> forms_;
  const std::shared_ptr<ui::FormDraft> draft_;
  ui::FormSubject subject_;                   ///< attempt and author of the answers in the form
  std::pair<ui::FormSubject, Form> handing_;  ///< subject and form that were submitted last
  QTimer keeping_;
  QButtonGroup* tabs_;
  QComboBox* choice_;
  QLabel *words_, *progress_;
  QStackedWidget* pages_;
  QScrollArea* scroll_;
  ui::FormSheet* sheet_ = nullptr;
  QPushButton *handIn_, *confirm_, *cancel_;
  JudgementTable* table_;
  bool hasChosen_ = false;  ///< the user has chosen a form
};

}  // namespace insonate::review
