#include "AttemptKeeper.h"

#include "../attempt/AttemptControl.h"
#include "UnsentFacts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Account.h>

#include <QThreadPool>
#include <QUuid>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kAgain_ms = 60'000;

Result<void> store(const AttemptStore& attempts, const AttemptFacts& facts) {
  if (const auto begun = attempts.begin(facts); !begun) return tl::unexpected(begun.error());
  return facts.state == AttemptState::Open ? Result<void>() : attempts.end(facts);
}

/// On this computer first. What cannot even be written there may still reach the store.
Result<void> keepHere(const QString& folder, AttemptFacts& facts, const QString& recording) {
  if (!recording.isEmpty())
    if (const auto added = addRecording(facts, recording.toStdString()); !added) facts.recording.clear();
  return keepUnsent(folder, facts);
}

/// One that the store refuses keeps no other from it. A server that is away is not waited for once for each.
Result<void> sendAll(const SignedIn& by, const QString& folder, std::optional<AttemptFacts> fresh,
                     const QString& recording, bool isAway) {
  const AttemptStore attempts(by);
  if (fresh && !keepHere(folder, *fresh, recording)) return store(attempts, *fresh);
  if (isAway) return fail(AttemptKeeper::tr("The server is still away.").toStdString());
  Result<void> first;
  for (const AttemptFacts& facts : unsentOf(folder, by.person().id)) {
    const auto stored = store(attempts, facts);
    if (stored) forgetUnsent(folder, facts);
    if (!stored && first) first = stored;
  }
  return first;
}

}  // namespace

AttemptKeeper::AttemptKeeper(AttemptControl& attempt, QString folder, QObject* parent)
    : QObject(parent), attempt_(attempt), folder_(std::move(folder)) {
  connect(&attempt_, &AttemptControl::begun, this, [this] { begin(); });
  connect(&attempt_, &AttemptControl::ended, this, [this] { end(); });
  again_.setInterval(kAgain_ms);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, [this] { send(std::nullopt, {}); });
}

void AttemptKeeper::setAccount(ui::Account& account) {
  account_ = &account;
  const auto changed = [this] {
    if (facts_ && facts_->person != account_->person().id) attempt_.close();
    send(std::nullopt, {});
  };
  connect(account_, &ui::Account::changed, this, changed);
  connect(account_, &ui::Account::cameBack, this, [this] { send(std::nullopt, {}); });
  changed();
}

void AttemptKeeper::begin() {
  facts_.reset();
  if (!account_ || !account_->isSignedIn() || account_->mustChangePassword()) return;
  facts_ = beginningOf(attempt_.header());
  facts_->id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  facts_->person = account_->person().id;
  if (const AttemptAim aim = aim_ ? aim_() : AttemptAim(); aim.level) {
    facts_->curriculum = aim.curriculum->name, facts_->curriculumVersion = aim.curriculum->version;
    facts_->level = aim.level->name;
  }
  keep(*facts_, {});
}

void AttemptKeeper::end() {
  if (!facts_) return;
  AttemptFacts facts = *std::exchange(facts_, std::nullopt);
  addEnding(facts, attempt_.status(), std::int64_t(attempt_.view().time_s * 1e6), attempt_.score());
  keep(facts, attempt_.file());
  if (account_->isSignedIn() && account_->person().id == facts.person) Q_EMIT ended(facts);
}

void AttemptKeeper::keep(const AttemptFacts& facts, const QString& recording) {
  if (account_->isSignedIn() && account_->person().id == facts.person) return send(facts, recording);
  QThreadPool::globalInstance()->start(
      [folder = folder_, late = AttemptFacts(facts), recording]() mutable { (void)keepHere(folder, late, recording); });
}

void AttemptKeeper::send(std::optional<AttemptFacts> fresh, const QString& recording) {
  if (!account_ || !account_->isSignedIn() || account_->mustChangePassword()) return;
  const bool isFresh = fresh.has_value();
  account_->ask<void>(
      this,
      [folder = folder_, fresh = std::move(fresh), recording, isAway = account_->isAway()](const SignedIn& by) {
        return sendAll(by, folder, fresh, recording, isAway);
      },
      [this, isFresh, person = account_->person().id](const Result<void>& sent) {
        if (person == account_->person().id) tell(sent, isFresh);
      });
}

/// The same trouble once for each beginning and end.
void AttemptKeeper::tell(const Result<void>& sent, bool isFresh) {
  const std::string trouble = std::exchange(trouble_, sent ? std::string() : sent.error().message);
  if (sent) {
    again_.stop();
    return Q_EMIT allSent();
  }
  again_.start();
  if (isFresh || trouble != trouble_)
    Q_EMIT said(tr("%1 Your attempts are kept on this computer and sent later.").arg(QString::fromStdString(trouble_)));
}

}  // namespace insonate::train
