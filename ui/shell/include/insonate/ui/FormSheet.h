#pragma once

#include <insonate/curriculum/Form.h>

#include <QWidget>
#include <vector>

namespace insonate::ui {

class FormQuestion;

/// A widget in which the user fills in a questionnaire, checklist or rating by mouse or keyboard: Tab goes to the next
/// question, arrow keys choose an answer, Delete clears it. Items of checklists and ratings have a field for a note.
/// The owner of the widget stores the answers.
class FormSheet final : public QWidget {
  Q_OBJECT

 public:
  explicit FormSheet(Form form, QWidget* parent = nullptr);

  const Form& form() const { return form_; }
  FormAnswers answers() const;
  /// Shows these answers. Ignores answers to questions that the form does not contain, and answers that the widget
  /// cannot show. Does not emit changed().
  void setAnswers(const FormAnswers& answers);
  /// States below each question the answer that the recording of the attempt gives in `found`.
  void showEvidence(const FormAnswers& found);
  /// Shows, beside each question whose answer cannot be stored, the error in the answer, and gives the first such
  /// question the keyboard focus. Returns true if there are no errors.
  bool check();

 Q_SIGNALS:
  void changed();

 private:
  Form form_;
  std::vector<FormQuestion*> questions_;  ///< widgets of the questions, in the order of the form
};

}  // namespace insonate::ui
