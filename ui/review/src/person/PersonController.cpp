#include "PersonController.h"

#include "../class/ClassWords.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/DayWatch.h>

#include <QDateTime>
#include <utility>

namespace insonate::review {

PersonController::PersonController(QObject* parent) : QObject(parent) {
  new ui::DayWatch([this] { refresh(); }, this);
}

void PersonController::setAccount(ui::Account& account) {
  account_ = &account;
  connect(account_, &ui::Account::reconnected, this, &PersonController::refresh);
}

template <class T, class Question, class Take>
void PersonController::ask(Question question, Take take) {
  if (asking_++ == 0) Q_EMIT readingChanged();
  account_->query<T>(this, std::move(question), [this, take = std::move(take), round = round_](Result<T> answer) {
    if (round == round_) take(std::move(answer));
    if (--asking_ == 0) Q_EMIT readingChanged();
  });
}

void PersonController::show(const std::string& person, const std::optional<Curriculum>& curriculum) {
  ++round_;
  person_ = person, curriculum_ = curriculum;
  facts_.reset(), attempts_.clear(), error_.clear(), earlier_ = false;
  Q_EMIT personChanged();
  Q_EMIT attemptsChanged();
  refresh();
}

void PersonController::refresh() {
  if (person_.empty() || !account_) return;
  const std::int64_t now_us = QDateTime::currentMSecsSinceEpoch() * 1000;
  ask<PersonFacts>([person = person_, curriculum = curriculum_,
                    now_us](const SignedIn& by) { return readPerson(by, person, curriculum, now_us); },
                   [this](Result<PersonFacts> facts) {
                     error_ = facts ? QString() : QString::fromStdString(facts.error().message);
                     if (facts) {
                       facts_ = std::move(*facts);
                       attempts_ = facts_->newest;
                       earlier_ = int(attempts_.size()) == kPage;
                     }
                     Q_EMIT personChanged();
                     Q_EMIT attemptsChanged();
                   });
}

void PersonController::refreshComments() {
  if (!facts_) return;
  ask<AttemptNotes>([person = person_](const SignedIn& by) { return readAttemptCounts(by, person); },
                    [this](Result<AttemptNotes> counts) {
                      if (!counts) return Q_EMIT failed(QString::fromStdString(counts.error().message));
                      if (!facts_) return;
                      AttemptNotes& notes = facts_->notes;
                      if (notes.comments == counts->comments && notes.forms == counts->forms) return;
                      notes.comments = std::move(counts->comments), notes.forms = std::move(counts->forms);
                      Q_EMIT attemptsChanged();
                    });
}

void PersonController::readEarlier() {
  if (!earlier_ || attempts_.empty()) return;
  earlier_ = false;
  ask<std::vector<StoredAttempt>>([person = person_, before = attempts_.back().arrival](
                                      const SignedIn& by) { return AttemptStore(by).page(person, kPage, before); },
                                  [this](Result<std::vector<StoredAttempt>> page) {
                                    if (!page) return Q_EMIT failed(QString::fromStdString(page.error().message));
                                    earlier_ = int(page->size()) == kPage;
                                    attempts_.insert(attempts_.end(), page->begin(), page->end());
                                    Q_EMIT attemptsChanged();
                                  });
}

QString PersonController::storeAddress() const {
  return account_ ? account_->address() : QString();
}

bool PersonController::mayVoid() const {
  return account_ && account_->isSignedIn() && account_->person().role != Role::Trainee &&
         account_->person().id != person_;
}

QString PersonController::attentionReason(const AttemptFacts& attempt) const {
  if (!mayVoid() || !facts_) return {};
  const auto& implausible = facts_->notes.implausible;
  const auto found = implausible.find(attempt.id);
  return found == implausible.end() ? QString() : displayText(attempt, found->second);
}

void PersonController::voidAttempt(const std::string& attempt, const QString& reason) {
  changeCount([attempt, reason = reason.toStdString()](const SignedIn& by) {
    return AttemptStore(by).voidAttempt(attempt, reason);
  });
}

void PersonController::acceptAttempt(const std::string& attempt, const QString& reason) {
  changeCount([attempt, reason = reason.toStdString()](const SignedIn& by) {
    return AttemptStore(by).accept(attempt, reason);
  });
}

void PersonController::changeCount(std::function<Result<void>(const SignedIn&)> change) {
  ask<bool>(
      [change = std::move(change)](const SignedIn& by) -> Result<bool> {
        if (const auto done = change(by); !done) return tl::unexpected(done.error());
        return true;
      },
      [this](const Result<bool>& done) {
        if (!done) return Q_EMIT failed(QString::fromStdString(done.error().message));
        Q_EMIT countChanged();
        refresh();
      });
}

}  // namespace insonate::review
