#include "JudgingController.h"

#include "../ReviewSession.h"
#include "../class/ClassWords.h"

#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/RepeatedValues.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/AttemptWords.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace insonate::review {
namespace {

/// Finds a recording's origin. `expected` is the id of the attempt that the user selected; if it is "", the attempt is
/// looked up. Fails if the user may not see the attempt. For the account's thread.
Result<RecordingOrigin> readOrigin(const SignedIn& by, const std::string& file, const std::string& expected) {
  const auto hash = recordingHash(file);
  if (!hash) return tl::unexpected(hash.error());
  const AttemptStore attempts(by);
  const auto id = expected.empty() ? attempts.findByRecording(std::filesystem::path(file).filename().string(), *hash)
                                   : Result<std::string>(expected);
  if (!id) return tl::unexpected(id.error());
  RecordingOrigin origin;
  if (id->empty()) return origin;
  auto kept = attempts.attempt(*id);
  if (!kept) return tl::unexpected(kept.error());
  origin.attempt = std::move(kept->facts);
  origin.same = origin.attempt->recordingHash == *hash;
  auto person = PeopleStore(by).person(origin.attempt->person);
  if (!person) return tl::unexpected(person.error());
  origin.person = std::move(*person);
  auto forms = FormStore(by).listByAttempt(*id);
  if (!forms) return tl::unexpected(forms.error());
  origin.forms = std::move(*forms);
  const auto repeated = repeatedValues(by, origin.attempt->person);
  if (!repeated) return tl::unexpected(repeated.error());
  origin.flags = implausibilities(*origin.attempt);
  if (repeated->contains(*id)) origin.flags.push_back(Implausible::SameValues);
  return origin;
}

}  // namespace

JudgingController::JudgingController(const ReviewSession& session, QObject* parent)
    : QObject(parent), session_(session) {
  connect(&session, &ReviewSession::attemptChanged, this, [this] { look(); });
}

void JudgingController::setAccount(ui::Account& account) {
  account_ = &account;
  connect(account_, &ui::Account::changed, this, [this] { look(); });
  connect(account_, &ui::Account::reconnected, this, [this] {
    if (!error_.isEmpty()) look();
  });
  look();
}

void JudgingController::expect(const QString& file, const QString& attempt) {
  expectedFile_ = file, expectedAttempt_ = attempt;
}

void JudgingController::look() {
  ++round_;
  origin_.reset(), error_.clear();
  reading_ = session_.attempt() && account_ && account_->isSignedIn() && !account_->mustChangePassword();
  Q_EMIT changed();
  if (!reading_) return;
  const std::string file = session_.attempt()->file;
  const bool chosen = file == expectedFile_.toStdString();
  account_->query<RecordingOrigin>(
      this,
      [file, expected = chosen ? expectedAttempt_.toStdString() : std::string()](const SignedIn& by) {
        return readOrigin(by, file, expected);
      },
      [this, round = round_](Result<RecordingOrigin> origin) {
        if (round != round_) return;
        reading_ = false;
        if (origin)
          origin_ = std::move(*origin);
        else
          error_ = QString::fromStdString(origin.error().message);
        Q_EMIT changed();
      });
}

QString JudgingController::nameOfPerson() const {
  const Person& person = origin_->person;
  return QString::fromStdString(person.fullName.empty() ? person.name : person.fullName);
}

QString JudgingController::trainee() const {
  return origin_ && origin_->attempt && !isOther() ? nameOfPerson() : QString();
}

QString JudgingController::words() const {
  if (!error_.isEmpty()) return error_;
  if (reading_) return tr("Identifying the attempt ...");
  if (!origin_) return tr("Sign in (Ctrl+L) to see checklists and ratings of attempts.");
  if (!origin_->attempt)
    return tr(
        "This recording belongs to no stored attempt: it was practice without a level or an account. It can be "
        "replayed but not judged.");
  const AttemptFacts& attempt = *origin_->attempt;
  const QString when = ui::dayAndTimeOf(attempt.begun_us);
  if (!origin_->same)
    return tr("This file is not the recording of the attempt of %1, %2, or it was changed later. It cannot be judged. "
              "Use the original recording made on %3.")
        .arg(nameOfPerson(), when, QString::fromStdString(attempt.workstation));
  if (mayJudge()) return tr("%1, attempt of %2").arg(nameOfPerson(), when);
  return tr("Your attempt of %1. Judgements by your instructors appear here.").arg(when);
}

bool JudgingController::mayJudge() const {
  return origin_ && origin_->attempt && origin_->same && account_->isSignedIn() &&
         account_->person().role != Role::Trainee && account_->person().id != origin_->person.id;
}

bool JudgingController::hasHandedIn(const std::string& form) const {
  return origin_ && account_->isSignedIn() && std::ranges::any_of(origin_->forms, [&](const StoredForm& one) {
           return one.filled.form == form && one.filled.by == account_->person().id;
         });
}

ui::FormSubject JudgingController::subject() const {
  if (!mayJudge()) return {};
  return {account_->person().id, origin_->attempt->id};
}

void JudgingController::handIn(const Form& form, const FormAnswers& answers, std::function<void()> stored) {
  if (!mayJudge()) return;
  FilledForm filled;
  filled.form = form.name, filled.formVersion = form.version;
  filled.person = origin_->person.id, filled.attempt = origin_->attempt->id;
  filled.by = account_->person().id;
  filled.answers = answersText(answers);
  filled = sending_.identified(std::move(filled));
  account_->query<std::string>(
      this,
      [filled, stored = std::move(stored)](const SignedIn& by) {
        auto id = FormStore(by).add(filled);
        if (id) stored();
        return id;
      },
      [this](const Result<std::string>& id) {
        if (!id)
          return Q_EMIT failed(QString::fromStdString(id.error().message),
                               tr("Your answers are kept on this computer; hand in the form again later."));
        sending_.stored();
        Q_EMIT handedIn();
        look();
      });
}

}  // namespace insonate::review
