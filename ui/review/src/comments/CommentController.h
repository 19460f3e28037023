#pragma once

#include <insonate/curriculum/CommentStore.h>

#include <QObject>
#include <QString>
#include <string>
#include <vector>

namespace insonate::ui {
class Account;
}

namespace insonate::review {

class JudgingController;
class ReviewSession;

/// Comments on the open attempt, in the order of their times. Uses no widgets. The store is queried on the account's
/// thread. If the trainee of the attempt is signed in, reading the comments marks them as read in the store; in
/// comments() they stay unread until the attempt is opened again.
class CommentController : public QObject {
  Q_OBJECT

 public:
  CommentController(const ReviewSession& session, const JudgingController& judging, QObject* parent = nullptr);
  void setAccount(ui::Account& account);

  const std::vector<AttemptComment>& comments() const { return comments_; }
  bool isReading() const { return asking_ > 0; }
  /// Id of the attempt to which the comments belong; empty if the recording belongs to no attempt that the user may
  /// see.
  const std::string& attempt() const { return attempt_; }
  /// Tells whether the user may comment on the attempt.
  bool mayWrite() const;
  bool mayRemove(const AttemptComment& comment) const;

  /// Stores a comment. Emits written() or failed(), also if another attempt is open by then.
  void write(std::int64_t at_us, const QString& text);
  void remove(const AttemptComment& comment);

 Q_SIGNALS:
  void changed();
  void written(const std::string& attempt);
  void failed(const QString& what, const QString& advice);

 private:
  void look();
  void read();
  template <class T, class Question, class Done>
  void ask(Question question, Done done);

  const ReviewSession& session_;
  const JudgingController& judging_;
  ui::Account* account_ = nullptr;
  std::string attempt_, file_, reader_;  ///< reader_: user who read the comments
  std::vector<AttemptComment> comments_;
  int asking_ = 0, round_ = 0;  ///< round_: number of the last attempt or user; results for earlier ones are dropped
};

}  // namespace insonate::review
