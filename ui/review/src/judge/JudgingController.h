#pragma once

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/ui/FormDraft.h>
#include <insonate/ui/FormSending.h>

#include <QObject>
#include <QString>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

class ReviewSession;

/// The attempt to which a recording belongs according to the store, and the trainee of that attempt.
struct RecordingOrigin {
  std::optional<AttemptFacts> attempt{};  ///< attempt with this recording; empty if the store has none
  Person person{};                        ///< trainee of the attempt
  bool same = false;                      ///< true: the file has the SHA-256 of the attempt's recording
  std::vector<StoredForm> forms{};        ///< forms about the attempt, in the order of submission
  std::vector<Implausible> flags{};       ///< reasons why the attempt is implausible
};

/// The trainee of a replayed attempt, and the raters' judgements of the attempt. Uses no widgets. The store is queried
/// on the account's thread.
class JudgingController : public QObject {
  Q_OBJECT

 public:
  explicit JudgingController(const ReviewSession& session, QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  /// Announces that the file to be opened next was selected as this attempt's recording.
  void expect(const QString& file, const QString& attempt);

  /// Origin of the recording; empty until it is known.
  const std::optional<RecordingOrigin>& origin() const { return origin_; }
  bool isReading() const { return reading_; }
  /// Tells whether the file differs from the attempt's recording; the replay is then not the trainee's attempt.
  bool isOther() const { return origin_ && origin_->attempt && !origin_->same; }
  /// Returns the name of the attempt's trainee; empty while it is unknown, or if the file is another recording.
  QString trainee() const;
  /// Returns the name of the attempt's trainee, or the reason why there is none.
  QString words() const;
  /// Tells whether the user may submit judgements of this attempt: the user must be an instructor or administrator and
  /// not the trainee, and the file must be the attempt's recording.
  bool mayJudge() const;
  /// Tells whether the user has already submitted this form about the attempt; a form can be submitted only once.
  bool hasHandedIn(const std::string& form) const;
  /// Key under which drafts of the user's answers are stored.
  ui::FormSubject subject() const;

  /// Submits a form; this cannot be undone. Emits handedIn() or failed(). When the store has the form, `stored` is
  /// called on the account's thread, even if another user is signed in by then.
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
  QString error_;
  bool reading_ = false;
  int round_ = 0;  ///< number of the last attempt; results about earlier attempts are dropped
};

}  // namespace insonate::review
