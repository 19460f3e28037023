#include "ClassController.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/DayWatch.h>

#include <algorithm>

namespace insonate::review {
namespace {

using Standings = std::map<std::string, Standing>;

/// Number of people whose attempts are read in one query, which other queries must wait for.
constexpr std::ptrdiff_t kTogether = 20;

}  // namespace

ClassController::ClassController(QObject* parent) : QObject(parent) {
  new ui::DayWatch([this] { refresh(); }, this);
}

void ClassController::setAccount(ui::Account& account) {
  account_ = &account;
  connect(account_, &ui::Account::changed, this, [this] {
    forget();
    refresh();
  });
  connect(account_, &ui::Account::peopleChanged, this, &ClassController::refresh);
  connect(account_, &ui::Account::reconnected, this, &ClassController::refresh);
  refresh();
}

bool ClassController::isSomebody() const {
  return account_ && account_->isSignedIn() && !account_->mustChangePassword();
}

bool ClassController::teaches() const {
  return isSomebody() && account_->person().role != Role::Trainee;
}

bool ClassController::administers() const {
  return isSomebody() && account_->person().role == Role::Administrator;
}

const Curriculum* ClassController::curriculum() const {
  if (facts_) return facts_->curriculum ? &*facts_->curriculum : nullptr;
  return own_ ? &*own_ : nullptr;
}

const HeatMap& ClassController::heat() const {
  static const HeatMap none;
  return facts_ ? facts_->heat : none;
}

/// The data of the former user must not stay visible.
void ClassController::forget() {
  cohorts_.clear(), queue_.clear(), codes_.clear();
  facts_.reset(), own_.reset(), error_.clear();
  chosen_ = 0, ++round_;
  Q_EMIT cohortsChanged();
  Q_EMIT classChanged();
}

template <class T, class Question, class Take>
void ClassController::ask(Question question, Take take) {
  if (asking_++ == 0) Q_EMIT readingChanged();
  account_->query<T>(this, std::move(question), [this, take = std::move(take), round = round_](Result<T> answer) {
    if (round == round_ && !answer) error_ = QString::fromStdString(answer.error().message);
    if (round == round_ && answer) take(std::move(*answer));
    if (--asking_ == 0) Q_EMIT readingChanged();
    if (!answer) Q_EMIT classChanged();
  });
}

void ClassController::refresh() {
  if (isSomebody()) readCohorts();
}

void ClassController::readCohorts() {
  error_.clear();
  ask<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); },
                           [this](std::vector<Cohort> cohorts) {
                             const std::string before = cohorts_.empty() ? "" : cohorts_[std::size_t(chosen_)].id;
                             cohorts_ = std::move(cohorts);
                             const auto same = std::ranges::find(cohorts_, before, &Cohort::id);
                             chosen_ = same == cohorts_.end() ? 0 : int(same - cohorts_.begin());
                             Q_EMIT cohortsChanged();
                             if (!cohorts_.empty()) return readClass();
                             facts_.reset(), own_.reset(), queue_.clear();
                             Q_EMIT classChanged();
                           });
}

void ClassController::choose(int cohort) {
  if (cohort < 0 || cohort >= int(cohorts_.size()) || cohort == chosen_) return;
  chosen_ = cohort, ++round_;
  facts_.reset(), own_.reset(), queue_.clear(), error_.clear();
  Q_EMIT classChanged();
  readClass();
}

void ClassController::readClass() {
  const Cohort cohort = cohorts_[std::size_t(chosen_)];
  if (teaches())
    ask<ClassFacts>([cohort](const SignedIn& by) { return review::readClass(by, cohort); },
                    [this](ClassFacts facts) { take(std::move(facts)); });
  else
    ask<Curriculum>([cohort](const SignedIn& by) { return curriculumOf(by, cohort); },
                    [this](Curriculum curriculum) {
                      own_ = std::move(curriculum);
                      Q_EMIT classChanged();
                    });
}

void ClassController::take(ClassFacts facts) {
  facts_ = std::move(facts);
  const bool idle = queue_.empty();
  queue_.clear();
  if (facts_->curriculum)
    for (const Member& one : facts_->learners)
      if (one.attempts > 0 && !one.standingIsCurrent) queue_.push_back(one.person.id);
  std::ranges::reverse(queue_);
  Q_EMIT classChanged();
  if (idle) nextStandings();
}

void ClassController::take(const std::string& person, Standing standing) {
  const auto member = std::ranges::find(facts_->learners, person, [](const Member& one) { return one.person.id; });
  if (member == facts_->learners.end()) return;
  member->standingIsCurrent = standing.changes == member->changes;
  member->standing = std::move(standing);
}

void ClassController::nextStandings() {
  if (queue_.empty() || !isSomebody() || !facts_->curriculum) return queue_.clear();
  const std::vector<std::string> some(queue_.end() - std::min(kTogether, std::ssize(queue_)), queue_.end());
  account_->query<Standings>(
      this, [some, cohort = facts_->cohort.id](const SignedIn& by) { return CohortStore(by).standings(cohort, some); },
      [this, some, round = round_](Result<Standings> standings) {
        if (round != round_) return nextStandings();
        std::erase_if(queue_, [&](const std::string& id) { return std::ranges::count(some, id) > 0; });
        if (standings)
          for (auto& [id, one] : *standings) take(id, std::move(one));
        for (const std::string& id : some) Q_EMIT standingChanged(QString::fromStdString(id));
        nextStandings();
      });
}

}  // namespace insonate::review
