#include "AttemptKeeper.h"

#include "../attempt/AttemptControl.h"
#include "UnsentFacts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Account.h>

#include <QUuid>
#include <QtConcurrent/QtConcurrentRun>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kAgain_ms = 60'000;

Result<void> store(const AttemptStore& attempts, const AttemptFacts& facts) {
  if (const auto begun = attempts.begin(facts); !begun) return tl::unexpected(begun.error());
  return facts.state == AttemptState::Open ? Result<void>() : attempts.end(facts);
}

/// On this computer, and at once: a question to a lost server may keep the account waiting. What cannot even be written
/// here, and an end without a recording, of which a file would be no proof, may still reach the store.
KeptFacts keepHere(const QString& folder, const AttemptFacts& facts, const QString& recording) {
  return QtConcurrent::run([folder, facts = AttemptFacts(facts), recording]() mutable -> std::optional<AttemptFacts> {
    const bool isProved = !recording.isEmpty() && takeRecording(facts, recording.toStdString());
    // A damaged one is still the attempt's.
    if (!isProved && !recording.isEmpty() && !addRecording(facts, recording.toStdString())) facts.recording.clear();
    const bool isWritten = keepUnsent(folder, facts).has_value();
    if (isWritten && (isProved || facts.state == AttemptState::Open)) return std::nullopt;
    return facts;
  });
}

/// Also its recording, beside the store. Gives why that could not be copied, "" where it was: the attempt counts all
/// the same, and its recording stays where it was made.
Result<std::string> send(const AttemptStore& attempts, const QString& folder, const AttemptFacts& facts) {
  if (const auto stored = store(attempts, facts); !stored) return tl::unexpected(stored.error());
  const QString recording = recordingOf(folder, facts);
  const auto copied = recording.isEmpty() ? Result<void>() : attempts.keepRecording(facts.id, recording.toStdString());
  forgetUnsent(folder, facts);
  return copied ? std::string() : copied.error().message;
}

/// One that the store refuses keeps no other from it. A server that is away is not waited for once for each.
Result<std::string> sendAll(const SignedIn& by, const QString& folder, const std::optional<KeptFacts>& fresh,
                            bool isAway) {
  const AttemptStore attempts(by);
  if (fresh)
    if (const auto unwritten = fresh->result()) return send(attempts, folder, *unwritten);
  if (isAway) return fail(AttemptKeeper::tr("The server is still away.").toStdString());
  std::string unkept;
  Result<std::string> first;
  for (const AttemptFacts& facts : unsentOf(folder, by.person().id)) {
    const auto sent = send(attempts, folder, facts);
    if (sent && !sent->empty()) unkept = *sent;
    if (!sent && first) first = sent;
  }
  return first ? Result<std::string>(unkept) : first;
}

}  // namespace

AttemptKeeper::AttemptKeeper(AttemptControl& attempt, QString folder, QObject* parent)
    : QObject(parent), attempt_(attempt), folder_(std::move(folder)) {
  connect(&attempt_, &AttemptControl::begun, this, [this] { begin(); });
  connect(&attempt_, &AttemptControl::ended, this, [this] { end(); });
  again_.setInterval(kAgain_ms);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, [this] { send(std::nullopt); });
}

void AttemptKeeper::setAccount(ui::Account& account) {
  account_ = &account;
  const auto changed = [this] {
    if (facts_ && facts_->person != account_->person().id) attempt_.close();
    send(std::nullopt);
  };
  connect(account_, &ui::Account::changed, this, changed);
  connect(account_, &ui::Account::cameBack, this, [this] { send(std::nullopt); });
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
  const KeptFacts kept = keepHere(folder_, facts, recording);
  if (account_->isSignedIn() && account_->person().id == facts.person) send(kept);
}

void AttemptKeeper::send(const std::optional<KeptFacts>& fresh) {
  if (!account_ || !account_->isSignedIn() || account_->mustChangePassword()) return;
  account_->ask<std::string>(
      this,
      [folder = folder_, fresh, isAway = account_->isAway()](const SignedIn& by) {
        return sendAll(by, folder, fresh, isAway);
      },
      [this, isFresh = fresh.has_value(), person = account_->person().id](const Result<std::string>& sent) {
        if (person == account_->person().id) tell(sent, isFresh);
      });
}

/// The same trouble once for each beginning and end.
void AttemptKeeper::tell(const Result<std::string>& sent, bool isFresh) {
  const std::string trouble = std::exchange(trouble_, sent ? std::string() : sent.error().message);
  if (sent) {
    again_.stop();
    if (!sent->empty())
      Q_EMIT said(tr("%1 The attempt counts; its recording stays in the folder of your attempts.")
                      .arg(QString::fromStdString(*sent)));
    return Q_EMIT allSent();
  }
  again_.start();
  if (isFresh || trouble != trouble_)
    Q_EMIT said(tr("%1 Your attempts are kept on this computer and sent later.").arg(QString::fromStdString(trouble_)));
}

}  // namespace insonate::train
