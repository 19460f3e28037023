#include "FormQuestion.h"

#include <insonate/ui/FormSheet.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::ui {
FormSheet::FormSheet(Form form, QWidget* parent) : QWidget(parent), form_(std::move(form)) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kLargeGap);
  for (const FormSection& section : form_.sections) {
    box->addWidget(paragraph("", "heading", QString::fromStdString(section.title)));
    if (!section.about.empty()) box->addWidget(paragraph("", "quiet", QString::fromStdString(section.about)));
    for (const FormItem& item : section.items) {
      auto* question = new FormQuestion(item, form_.acceptsNote(item));
      connect(question, &FormQuestion::changed, this, [this, question] {
        question->setError({});
        Q_EMIT changed();
      });
      questions_.push_back(question);
      box->addWidget(question);
    }
  }
  box->addStretch(1);
}

FormAnswers FormSheet::answers() const {
  FormAnswers all;
  for (const FormQuestion* question : questions_) {
    if (const auto answer = question->answer()) all.emplace(question->name(), *answer);
    if (const QString note = question->note(); !note.isEmpty()) all.emplace(question->noteKey(), note.toStdString());
  }
  return all;
}

void FormSheet::setAnswers(const FormAnswers& answers) {
  for (FormQuestion* question : questions_) {
    const auto found = answers.find(question->name());
    question->setAnswer(found == answers.end() ? std::nullopt : std::optional(found->second));
    const FormItem* item = form_.item(question->name());
    question->setNote(item ? QString::fromStdString(noteText(*item, answers)) : QString());
    question->setError({});
  }
}

void FormSheet::showEvidence(const FormAnswers& found) {
  for (FormQuestion* question : questions_)
    if (const FormItem* item = form_.item(question->name()))
      question->setEvidence(QString::fromStdString(answerText(*item, found)));
}

bool FormSheet::check() {
  const std::vector<AnswerError> errors = checkAnswers(form_, answers());
  FormQuestion* first = nullptr;
  for (FormQuestion* question : questions_) {
    const auto found = std::ranges::find_if(errors, [question](const AnswerError& one) {
      return one.item == question->name() || one.item == question->noteKey();
    });
    question->setError(found == errors.end() ? QString() : QString::fromStdString(found->sentence));
    if (found != errors.end() && !first) first = question;
  }
  if (first) first->takeKeyboard();
  return !first;
}

}  // namespace insonate::ui
