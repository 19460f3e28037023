#pragma once

#include <insonate/curriculum/Form.h>

#include <QWidget>
#include <vector>

namespace insonate::ui {

class FormQuestion;

/// A questionnaire, checklist or rating to fill in, by mouse or keyboard: Tab goes from question to question, arrows
/// choose among answers, Delete takes a choice back. Checklists and ratings have room for a note to each item. Where
/// answers are kept is the owner's business.
class FormSheet final : public QWidget {
  Q_OBJECT

 public:
  explicit FormSheet(Form form, QWidget* parent = nullptr);

  const Form& form() const { return form_; }
  FormAnswers answers() const;
  /// Shows answers; those to items that the form lacks or cannot show are ignored. Does not emit changed().
  void setAnswers(const FormAnswers& answers);
  /// Shows beside each question the error that keeps the answers from being stored, and gives the first of them the
  /// keyboard focus; true without errors.
  bool check();

 Q_SIGNALS:
  void changed();

 private:
  Form form_;
  std::vector<FormQuestion*> questions_;  ///< in the order of the form
};

}  // namespace insonate::ui
