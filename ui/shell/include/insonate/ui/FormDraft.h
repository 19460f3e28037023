#pragma once

#include <insonate/curriculum/Form.h>

#include <QString>
#include <QThreadPool>
#include <string>

namespace insonate::ui {

/// Author and subject of the answers; both ids are UUIDs.
struct FormSubject {
  std::string by{};
  std::string attempt{};  ///< "": about none in particular

  bool operator==(const FormSubject&) const = default;
};

/// Unsent answers, in a file of the user's for each subject and form, so that they outlive the program. Any thread;
/// another thread writes them, one after the other.
class FormDraft {
 public:
  explicit FormDraft(QString folder);
  /// Waits until all drafts are written.
  ~FormDraft();

  /// Returns the stored answers; empty without any.
  FormAnswers read(const FormSubject& subject, const Form& form) const;
  /// Stores a draft; empty answers delete it.
  void keep(const FormSubject& subject, const Form& form, const FormAnswers& answers);

 private:
  QString fileOf(const FormSubject& subject, const Form& form) const;

  const QString folder_;
  QThreadPool writer_;  ///< of one thread: the later answers are written later
};

}  // namespace insonate::ui
