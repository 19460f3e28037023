#pragma once

#include <insonate/curriculum/Form.h>

#include <QString>
#include <QThreadPool>
#include <string>

namespace insonate::ui {

/// Author of the answers to a form, and the attempt that the form is about; both ids are UUIDs.
struct FormSubject {
  std::string by{};
  std::string attempt{};  ///< attempt that the form is about; "": no particular attempt

  bool operator==(const FormSubject&) const = default;
};

/// Stores answers that have not been sent yet, so that they are available after a restart of the program. There is one
/// file in the user's data for each subject and form. May be used on any thread. A background thread writes the files
/// one after the other.
class FormDraft {
 public:
  explicit FormDraft(QString folder);
  /// Waits until all drafts are written.
  ~FormDraft();

  /// Returns the answers of the stored draft; empty if there is no draft.
  FormAnswers read(const FormSubject& subject, const Form& form) const;
  /// Stores the answers as the draft for this subject and form; empty answers delete the draft.
  void save(const FormSubject& subject, const Form& form, const FormAnswers& answers);

 private:
  QString fileOf(const FormSubject& subject, const Form& form) const;

  const QString folder_;
  QThreadPool writer_;  ///< has one thread, so that drafts are written in their order
};

}  // namespace insonate::ui
