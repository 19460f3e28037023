#include "AttemptSaver.h"

#include "../attempt/AttemptControl.h"
#include "UnsentFacts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/Attempts.h>

#include <QUuid>
#include <QtConcurrent/QtConcurrentRun>
#include <tuple>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kAgain_ms = 60'000;

/// As its recording proves it; one that was changed meanwhile proves nothing, and the attempt is kept all the same.
Result<void> store(const AttemptStore& attempts, AttemptFacts facts, const QString& recording) {
  if (const auto begun = attempts.begin(facts); !begun) return tl::unexpected(begun.error());
  if (facts.state == AttemptState::Open) return {};
  const auto proven =
      recording.isEmpty() ? Result<AttemptProofOf>() : proofOfAttempt(attempts, facts, recording.toStdString());
  facts.proof = proven ? proven->proof : AttemptProof::Unproven;
  return attempts.end(facts);
}

/// On this computer, and at once: a question to a lost server may keep the account waiting. What cannot even be written
/// here, and an end without a recording, of which a file would be no proof, may still reach the store.
KeptFacts keepHere(const QString& folder, const AttemptFacts& facts, const QString& recording) {
  return QtConcurrent::run([folder, facts = AttemptFacts(facts), recording]() mutable -> std::optional<AttemptFacts> {
    const bool isProved = !recording.isEmpty() && takeRecording(facts, recording.toStdString());
    // A damaged one is still the attempt's.
    if (!isProved && !recording.isEmpty() && !addRecording(facts, recording.toStdString())) facts.recording.clear();
    const bool isWritten = storeUnsent(folder, facts).has_value();
    if (isWritten && (isProved || facts.state == AttemptState::Open)) return std::nullopt;
    return facts;
  });
}

/// Also its recording, beside the store. Gives why that could not be copied, "" where it was: the attempt counts all
/// the same, and its recording stays where it was made.
Result<std::string> send(const AttemptStore& attempts, const QString& folder, const AttemptFacts& facts) {
  const QString recording = recordingOf(folder, facts);
  if (const auto stored = store(attempts, facts, recording); !stored) return tl::unexpected(stored.error());
  const auto copied = recording.isEmpty() ? Result<void>() : attempts.storeRecording(facts.id, recording.toStdString());
  forgetUnsent(folder, facts);
  return copied ? std::string() : copied.error().message;
}

/// One that the store refuses keeps no other from it. A server that is away is not waited for once for each.
Result<std::string> sendAll(const SignedIn& by, const QString& folder, const std::optional<KeptFacts>& fresh,
                            bool isServerUnreachable) {
  const AttemptStore attempts(by);
  if (fresh)
    if (const auto unwritten = fresh->result()) return send(attempts, folder, *unwritten);
  if (isServerUnreachable) return fail(AttemptSaver::tr("The server is still unreachable.").toStdString());
  recoverInterrupted(folder, by.person().id);
  std::string unkept;
  Result<std::string> first;
  for (const AttemptFacts& facts : unsentOf(folder, by.person().id)) {
    const auto sent = send(attempts, folder, facts);
    if (sent && !sent->empty()) unkept = *sent;
    if (!sent && first) first = sent;
  }
  return first ? Result<std::string>(unkept) : first;
}

bool isSameAim(const AttemptFacts& a, const AttemptFacts& b) {
  const auto aim = [](const AttemptFacts& facts) {
    return std::tie(facts.person, facts.curriculum, facts.curriculumVersion, facts.level);
  };
  return aim(a) == aim(b);
}

}  // namespace

AttemptSaver::AttemptSaver(AttemptControl& attempt, QString folder, QObject* parent)
    : QObject(parent), attempt_(attempt), folder_(std::move(folder)) {
  connect(&attempt_, &AttemptControl::starting, this, [this] { start(); });
  connect(&attempt_, &AttemptControl::begun, this, [this] { begin(); });
  connect(&attempt_, &AttemptControl::ended, this, [this] { end(); });
  again_.setInterval(kAgain_ms);
  again_.setSingleShot(true);
  connect(&again_, &QTimer::timeout, this, [this] { send(std::nullopt); });
}

void AttemptSaver::setAccount(ui::Account& account) {
  account_ = &account;
  const auto changed = [this] {
    if (attempt_.isBusy() && !starter_.empty() && starter_ != account_->person().id) attempt_.close();
    send(std::nullopt);
    prepare();
  };
  connect(account_, &ui::Account::changed, this, changed);
  connect(account_, &ui::Account::reconnected, this, [this] {
    send(std::nullopt);
    prepare();
  });
  changed();
}

bool AttemptSaver::isKept() const {
  return account_ && account_->isSignedIn() && !account_->mustChangePassword();
}

/// Id, person and level of the next attempt of the user.
AttemptFacts AttemptSaver::nextFacts() const {
  AttemptFacts facts;
  facts.id = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  facts.person = account_->person().id;
  if (const AttemptAim aim = aim_ ? aim_() : AttemptAim(); aim.level) {
    facts.curriculum = aim.curriculum->name, facts.curriculumVersion = aim.curriculum->version;
    facts.level = aim.level->name;
  }
  return facts;
}

void AttemptSaver::prepare() {
  if (!isKept()) return next_.reset();
  if (next_ && isSameAim(next_->facts, nextFacts())) return;
  next_.reset();
  account_->query<Sealed>(
      this,
      [facts = nextFacts()](const SignedIn& by) -> Result<Sealed> {
        auto seal = AttemptStore(by).issueSeal(facts);
        if (!seal) return tl::unexpected(seal.error());
        return Sealed{facts, std::move(*seal)};
      },
      [this](Result<Sealed> sealed) { takeSeal(std::move(sealed)); });
}

void AttemptSaver::start() {
  starter_ = isKept() ? account_->person().id : std::string();
  isAwaited_ = !starter_.empty();
  if (!isAwaited_) return;
  attempt_.awaitSeal();
  next_ ? takeSeal(std::move(*next_)) : prepare();
}

/// One that was asked for another person or level is of no use.
void AttemptSaver::takeSeal(Result<Sealed> sealed) {
  const AttemptFacts now = isKept() ? nextFacts() : AttemptFacts();
  next_ = sealed && isSameAim(sealed->facts, now) ? std::optional(std::move(*sealed)) : std::nullopt;
  if (!std::exchange(isAwaited_, false)) return;
  if (!next_) return attempt_.setSeal({}, std::nullopt);
  const AttemptFacts& facts = next_->facts;
  attempt_.setSeal({facts.id, facts.person, facts.curriculum, facts.curriculumVersion, facts.level, next_->seal.nonce},
                   next_->seal.key);
}

void AttemptSaver::begin() {
  facts_.reset();
  isAwaited_ = false;
  if (!isKept()) return;
  const AttemptFacts unsealed = nextFacts();
  facts_ = factsFromHeader(attempt_.header());
  if (facts_->id.empty()) {
    facts_->id = unsealed.id, facts_->person = unsealed.person;
    facts_->curriculum = unsealed.curriculum, facts_->curriculumVersion = unsealed.curriculumVersion;
    facts_->level = unsealed.level;
  }
  if (const AttemptAim aim = aim_ ? aim_() : AttemptAim(); aim.level && sitting_)
    facts_->testConditions = sitting_(*aim.level);
  keep(*facts_, {});
  next_.reset();
  prepare();
}

void AttemptSaver::end() {
  if (!facts_) return;
  AttemptFacts facts = *std::exchange(facts_, std::nullopt);
  addEnding(facts, attempt_.status(), std::int64_t(attempt_.view().time_s * 1e6), attempt_.score());
  keep(facts, attempt_.file());
  // As the store will find it.
  const bool isSealed = !attempt_.header().recordedFor.nonce.empty() && !attempt_.file().isEmpty();
  facts.proof = isSealed ? AttemptProof::Proven : AttemptProof::Unproven;
  if (account_->isSignedIn() && account_->person().id == facts.person) Q_EMIT ended(facts);
}

void AttemptSaver::keep(const AttemptFacts& facts, const QString& recording) {
  const KeptFacts kept = keepHere(folder_, facts, recording);
  if (account_->isSignedIn() && account_->person().id == facts.person) send(kept);
}

void AttemptSaver::send(const std::optional<KeptFacts>& fresh) {
  if (!isKept()) return;
  account_->query<std::string>(
      this,
      [folder = folder_, fresh, isServerUnreachable = account_->isServerUnreachable()](const SignedIn& by) {
        return sendAll(by, folder, fresh, isServerUnreachable);
      },
      [this, isFresh = fresh.has_value(), person = account_->person().id](const Result<std::string>& sent) {
        if (person == account_->person().id) tell(sent, isFresh);
      });
}

/// The same trouble once for each beginning and end.
void AttemptSaver::tell(const Result<std::string>& sent, bool isFresh) {
  const std::string error = std::exchange(error_, sent ? std::string() : sent.error().message);
  if (sent) {
    again_.stop();
    if (!sent->empty())
      Q_EMIT messageReported(tr("%1 The attempt counts; its recording stays in the folder of your attempts.")
                                 .arg(QString::fromStdString(*sent)));
    return Q_EMIT allSent();
  }
  again_.start();
  if (isFresh || error != error_)
    Q_EMIT messageReported(
        tr("%1 Your attempts are kept on this computer and sent later.").arg(QString::fromStdString(error_)));
}

}  // namespace insonate::train
