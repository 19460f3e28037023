#include "Course.h"

#include "UnsentFacts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/DayWatch.h>

#include <QDateTime>
#include <algorithm>
#include <utility>

namespace insonate::train {
namespace {

std::int64_t now_us() {
  return QDateTime::currentMSecsSinceEpoch() * 1000;
}

Result<Curriculum> builtIn() {
  return loadCurriculum(curriculumPresetNames().front());
}

/// In the place of what is known of the same attempt.
void merge(std::vector<AttemptFacts>& history, const AttemptFacts& facts) {
  const auto found = std::ranges::find(history, facts.id, &AttemptFacts::id);
  found == history.end() ? void(history.push_back(facts)) : void(*found = facts);
}

}  // namespace

Course::Course(QString unsentFolder, QObject* parent) : QObject(parent), unsent_(std::move(unsentFolder)) {
  new ui::DayWatch([this] { workOut(); }, this);
}

void Course::setAccount(ui::Account& account) {
  account_ = &account;
  connect(account_, &ui::Account::changed, this, [this] {
    if (std::exchange(person_, account_->person().id) != person_) {
      wanted_.reset();
      known_.reset();
      error_.clear();
      workOut();
    }
    refresh();
  });
  connect(account_, &ui::Account::peopleChanged, this, &Course::refresh);
  connect(account_, &ui::Account::reconnected, this, &Course::refresh);
  connect(account_, &ui::Account::casesDownloaded, this, &Course::casesDownloaded);
  person_ = account_->person().id;
  refresh();
}

bool Course::isSomebodys() const {
  return account_ && account_->isSignedIn() && !account_->mustChangePassword();
}

QString Course::origin() const {
  if (!known_) return {};
  const std::string& cohort = known_->choices.empty() ? std::string() : known_->choices[known_->chosen].cohort;
  return cohort.empty() ? tr("built-in curriculum")
                        : tr("curriculum of the class %1").arg(QString::fromStdString(cohort));
}

const LevelProgress* Course::progressIn(std::string_view level) const {
  const auto found = std::ranges::find(progress_, level, &LevelProgress::level);
  return found == progress_.end() ? nullptr : &*found;
}

void Course::choose(int choice) {
  if (!known_ || choice < 0 || choice >= int(known_->choices.size()) || choice == known_->chosen) return;
  wanted_ = known_->choices[std::size_t(choice)];
  refresh();
}

void Course::refresh() {
  if (!isSomebodys()) {
    auto curriculum = builtIn();
    return take(curriculum ? Result<Known>(Known{{}, 0, std::move(*curriculum), {}})
                           : tl::unexpected(curriculum.error()));
  }
  account_->query<Known>(
      this, [unsent = unsent_, wanted = wanted_](const SignedIn& by) { return ask(by, unsent, wanted); },
      [this, person = account_->person().id](Result<Known> known) {
        if (person == account_->person().id) take(std::move(known));
      });
}

/// Curricula of the user's classes that are not archived; if none has one, the built-in curriculum.
Result<std::vector<Course::Choice>> Course::choicesOf(const SignedIn& by) {
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  std::vector<Choice> choices;
  for (const Cohort& cohort : *cohorts)
    if (!cohort.curriculum.empty() && !cohort.archived)
      choices.push_back({cohort.name, cohort.curriculum, cohort.curriculumVersion});
  if (choices.empty()) choices.push_back({});
  return choices;
}

/// On the account's thread.
Result<Course::Known> Course::ask(const SignedIn& by, const QString& unsent, const std::optional<Choice>& wanted) {
  auto choices = choicesOf(by);
  if (!choices) return tl::unexpected(choices.error());
  Known known{std::move(*choices), 0, {}, {}};
  if (const auto found = wanted ? std::ranges::find(known.choices, *wanted) : known.choices.end();
      found != known.choices.end())
    known.chosen = int(found - known.choices.begin());
  const Choice& chosen = known.choices[std::size_t(known.chosen)];
  const auto text = chosen.curriculum.empty() ? Result<std::string>()
                                              : PublishedCurricula(by).text(chosen.curriculum, chosen.version);
  if (!text) return tl::unexpected(text.error());
  auto curriculum = chosen.curriculum.empty() ? builtIn() : parseCurriculum(*text);
  if (!curriculum) return tl::unexpected(curriculum.error());
  known.curriculum = std::move(*curriculum);

  const std::string& person = by.person().id;
  auto history = AttemptStore(by).history(person);
  if (!history) return tl::unexpected(history.error());
  known.history = std::move(*history);
  for (AttemptFacts& facts : unsentOf(unsent, person)) {
    // The store decides whether a test was open.
    facts.testConditions = TestConditions::Undecided;
    merge(known.history, facts);
  }
  return known;
}

/// If the store does not answer, the former state stays.
void Course::take(Result<Known> known) {
  error_ = known ? QString() : QString::fromStdString(known.error().message);
  if (known) known_ = std::move(*known);
  workOut();
}

void Course::add(const AttemptFacts& ended) {
  if (!known_) return;
  merge(known_->history, ended);
  workOut();
}

void Course::workOut() {
  progress_ = known_ ? computeProgress(known_->curriculum, known_->history, now_us()) : std::vector<LevelProgress>{};
  Q_EMIT changed();
}

}  // namespace insonate::train
