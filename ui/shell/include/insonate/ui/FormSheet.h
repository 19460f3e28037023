#pragma once

#include <insonate/curriculum/Form.h>

#include <QWidget>
#include <vector>

namespace insonate::ui {

class FormQuestion;

/// A questionnaire, checklist or rating to fill in, by mouse or keyboard: Tab goes to the next question, arrows choose
/// an answer, Delete clears it. Checklists and ratings take a note for each item. The owner stores the answers.
class FormSheet final : public QWidget {
  Q_OBJECT

 public:
  explicit FormSheet(Form form, QWidget* parent = nullptr);

  const Form& form() const { return form_; }
  FormAnswers answers() const;
  /// Shows answers; answers to items that the form lacks or cannot show are ignored. Does not emit changed().
  void setAnswers(const FormAnswers& answers);
  /// Shows beside each question the error that keeps its answer from being stored, and gives the first such question
  /// the keyboard focus. Returns true if there are no errors.
  bool check();

 Q_SIGNALS:
  void changed();

 private:
  Form form_;
  std::vector<FormQuestion*> questions_;  ///< in the order of the form
};

}  // namespace insonate::ui
