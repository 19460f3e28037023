#pragma once

#include "RecordingOrigin.h"

#include <insonate/ui/FormDraft.h>
#include <insonate/ui/FormSending.h>

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <string>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

class ReviewSession;

/// The trainee of a replayed attempt, and the raters' judgements of it, without a widget. The store is queried on the
/// account's thread.
class JudgeDesk : public QObject {
  Q_OBJECT

 public:
  explicit JudgeDesk(const ReviewSession& session, QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  /// The recording that is about to be opened was chosen as that of an attempt.
  void expect(const QString& file, const QString& attempt);

  /// Origin of the recording; empty until it is known.
  const std::optional<RecordingOrigin>& origin() const { return origin_; }
  bool isReading() const { return reading_; }
  /// Tells whether the file differs from the recording of the attempt: then the replay is not the trainee's.
  bool isOther() const { return origin_ && origin_->attempt && !origin_->same; }
  /// Trainee of the attempt, or the reason why none is named.
  QString words() const;
  /// Tells whether the user may submit judgements of this attempt: it belongs to one of the user's trainees, and so
  /// does the recording.
  bool mayJudge() const;
  /// Tells whether the user has handed in this form about the attempt: a form is handed in once.
  bool hasHandedIn(const std::string& form) const;
  /// Key of the user's drafts.
  ui::FormSubject subject() const;

  /// Hands in a form for good; emits handedIn() or failed(). `stored` is called on the account's thread once the store
  /// has the form, whoever is signed in by then.
  void handIn(const Form& form, const FormAnswers& answers, std::function<void()> stored);

 Q_SIGNALS:
  void changed();
  void handedIn();
  void failed(const QString& what, const QString& advice);

 private:
  void look();
  QString nameOfPerson() const;

  const ReviewSession& session_;
  ui::Account* account_ = nullptr;
  QString expectedFile_, expectedAttempt_;
  std::optional<RecordingOrigin> origin_;
  ui::FormSending sending_;
  QString trouble_;
  bool reading_ = false;
  int round_ = 0;  ///< answers about another attempt are not taken
};

}  // namespace insonate::review
