#pragma once

#include <insonate/curriculum/Form.h>

#include <QString>
#include <QThreadPool>

namespace insonate::train {

/// Answers that were not sent yet, in a file of the user's for each person and form, so that they outlive the program.
/// For the window's thread; what is written, is written by another.
class FormDraft {
 public:
  explicit FormDraft(QString folder);
  /// Waits until what was kept is written.
  ~FormDraft();

  /// What was kept; empty without.
  FormAnswers read(const std::string& person, const Form& form) const;
  /// Empty answers forget.
  void keep(const std::string& person, const Form& form, const FormAnswers& answers);

 private:
  QString fileOf(const std::string& person, const Form& form) const;

  const QString folder_;
  QThreadPool writer_;  ///< of one thread: the later answers are written later
};

}  // namespace insonate::train
