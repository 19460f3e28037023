#include "CommentController.h"

#include "../ReviewSession.h"
#include "../judge/JudgingController.h"

#include <insonate/ui/Account.h>

#include <utility>

namespace insonate::review {
namespace {

/// Returns the comments. `isOwn`: the user made the attempt, and has read its comments now. For the account's thread.
Result<std::vector<AttemptComment>> readComments(const SignedIn& by, const std::string& attempt, bool isOwn) {
  const CommentStore store(by);
  auto comments = store.listByAttempt(attempt);
  if (!comments || comments->empty() || !isOwn) return comments;
  if (const auto read = store.markRead(attempt); !read) return tl::unexpected(read.error());
  return comments;
}

}  // namespace

CommentController::CommentController(const ReviewSession& session, const JudgingController& judging, QObject* parent)
    : QObject(parent), session_(session), judging_(judging) {
  connect(&judging, &JudgingController::changed, this, [this] { look(); });
}

void CommentController::setAccount(ui::Account& account) {
  account_ = &account;
}

bool CommentController::mayWrite() const {
  return !attempt_.empty() && judging_.mayJudge();
}

bool CommentController::mayRemove(const AttemptComment& comment) const {
  return account_ && account_->isSignedIn() && mayWrite() &&
         (comment.by == account_->person().id || account_->person().role == Role::Administrator);
}

template <class T, class Question, class Done>
void CommentController::ask(Question question, Done done) {
  ++asking_;
  account_->query<T>(this, std::move(question), [this, done = std::move(done)](const Result<T>& answer) {
    --asking_;
    done(answer);
    Q_EMIT changed();
  });
}

/// Comments are pinned to the original recording: a changed file shows none.
void CommentController::look() {
  const auto& origin = judging_.origin();
  const std::string reader = account_ && account_->isSignedIn() ? account_->person().id : std::string();
  const std::string file = session_.attempt() ? session_.attempt()->file : std::string();
  const bool isKnown = origin && origin->attempt && origin->same && !reader.empty();
  // The origin is read again after a form was handed in, which does not concern the comments.
  const bool isSame = reader == reader_ && file == file_;
  if (isSame && (judging_.isReading() || (isKnown && origin->attempt->id == attempt_))) return;
  ++round_;
  attempt_ = isKnown ? origin->attempt->id : std::string();
  reader_ = reader, file_ = file;
  comments_.clear();
  if (isKnown) read();
  Q_EMIT changed();
}

void CommentController::read() {
  const bool isOwn = judging_.origin() && judging_.origin()->person.id == reader_;
  ask<std::vector<AttemptComment>>(
      [attempt = attempt_, isOwn](const SignedIn& by) { return readComments(by, attempt, isOwn); },
      [this, round = round_](const Result<std::vector<AttemptComment>>& comments) {
        if (round != round_) return;
        if (!comments) return Q_EMIT failed(QString::fromStdString(comments.error().message), {});
        comments_ = *comments;
      });
}

void CommentController::write(std::int64_t at_us, const QString& text) {
  if (!mayWrite()) return;
  ask<std::string>([attempt = attempt_, at_us, text = text.toStdString()](
                       const SignedIn& by) { return CommentStore(by).add(attempt, at_us, text); },
                   [this, attempt = attempt_](const Result<std::string>& id) {
                     if (!id)
                       return Q_EMIT failed(
                           QString::fromStdString(id.error().message),
                           tr("The comment is not saved; its text stays in the field. Save the comment again later."));
                     Q_EMIT written(attempt);
                     if (attempt == attempt_) read();
                   });
}

void CommentController::remove(const AttemptComment& comment) {
  ask<bool>(
      [attempt = comment.attempt, id = comment.id](const SignedIn& by) -> Result<bool> {
        if (const auto done = CommentStore(by).remove(attempt, id); !done) return tl::unexpected(done.error());
        return true;
      },
      [this, attempt = comment.attempt](const Result<bool>& done) {
        if (!done) return Q_EMIT failed(QString::fromStdString(done.error().message), {});
        if (attempt == attempt_) read();
      });
}

}  // namespace insonate::review
