#include "TestAdmissions.h"

#include "Course.h"

#include <insonate/ui/Account.h>
#include <insonate/ui/AttemptWords.h>

#include <utility>
#include <vector>

namespace insonate::train {
namespace {

constexpr int kAskAgain_ms = 10'000;

bool isTest(const Level& level) {
  return level.assistance == Assistance::Test;
}

QString closedSentence(const TestAdmission& admission) {
  if (!admission.next_us)
    return TestAdmissions::tr(
        "○ Your instructor has not opened this test: an attempt now is practice and does not count.");
  return TestAdmissions::tr(
             "○ This test is not open yet: it opens on %1. Until then, an attempt is practice and does not count.")
      .arg(ui::dayAndTimeOf(*admission.next_us));
}

}  // namespace

TestAdmissions::TestAdmissions(Course& course, QObject* parent) : QObject(parent), course_(course) {
  connect(&course_, &Course::changed, this, &TestAdmissions::refresh);
  connect(&again_, &QTimer::timeout, this, &TestAdmissions::refresh);
  again_.start(kAskAgain_ms);
}

void TestAdmissions::setAccount(ui::Account& account) {
  account_ = &account;
  connect(account_, &ui::Account::changed, this, [this] { take(Known()); });
}

std::optional<TestAdmission> TestAdmissions::of(const Level& level) const {
  const auto found = known_.find(level.name);
  return found == known_.end() ? std::nullopt : std::optional(found->second);
}

QString TestAdmissions::findingText(const Level& level) const {
  if (!isTest(level) || !course_.isSomebodys()) return {};
  const auto admission = of(level);
  if (!admission)
    return tr(
        "▲ It is not known whether your instructor has opened this test. An attempt counts if the test is open when "
        "the attempt begins.");
  switch (admission->kind) {
    case TestAdmission::Kind::Open:
      return admission->end_us
                 ? tr("● Your instructor has opened this test until %1. An attempt that begins now counts.")
                       .arg(ui::dayAndTimeOf(*admission->end_us))
                 : tr("● Your instructor has opened this test. An attempt that begins now counts.");
    case TestAdmission::Kind::SelfAdministered:
      return tr("● You take this test without an instructor: the attempt counts and is shown as self-administered.");
    case TestAdmission::Kind::NeedsCode:
      return tr(
          "◔ Your instructor has opened this test with a code. Without the code, an attempt is practice and does not "
          "count.");
    case TestAdmission::Kind::Closed:
      break;
  }
  return closedSentence(*admission);
}

TestConditions TestAdmissions::expectedTestConditions(const Level& level) const {
  if (!isTest(level)) return TestConditions::None;
  const auto admission = of(level);
  if (!admission) return TestConditions::Undecided;
  if (admission->kind == TestAdmission::Kind::Open) return TestConditions::Opened;
  return admission->kind == TestAdmission::Kind::SelfAdministered ? TestConditions::SelfAdministered
                                                                  : TestConditions::Practice;
}

void TestAdmissions::refresh() {
  const Curriculum* curriculum = course_.curriculum();
  // A question to a server that is away would keep others waiting; the course is read again when it is back.
  if (!account_ || account_->isServerUnreachable() || !course_.isSomebodys() || !curriculum) return take(Known());
  std::vector<std::string> tests;
  for (const Level& level : curriculum->levels)
    if (isTest(level)) tests.push_back(level.name);
  if (tests.empty()) return take(Known());
  account_->query<Known>(
      this,
      [name = curriculum->name, tests](const SignedIn& by) -> Result<Known> {
        Known known;
        for (const std::string& test : tests) {
          const auto admission = OpeningStore(by).admission(name, test);
          if (!admission) return tl::unexpected(admission.error());
          known[test] = *admission;
        }
        return known;
      },
      [this](Result<Known> known) { take(std::move(known)); });
}

/// If the store does not answer, nothing is known.
void TestAdmissions::take(Result<Known> known) {
  Known now = known ? std::move(*known) : Known();
  if (now == known_) return;
  known_ = std::move(now);
  Q_EMIT changed();
}

void TestAdmissions::enterCode(const std::string& level, const QString& code, std::function<void(Result<void>)> done) {
  if (!account_ || !course_.curriculum()) return;
  account_->query<TestAdmission>(
      this,
      [name = course_.curriculum()->name, level, code = code.toStdString()](const SignedIn& by) {
        return OpeningStore(by).enterCode(name, level, code);
      },
      [this, level, done = std::move(done)](const Result<TestAdmission>& admission) {
        if (admission) {
          Known now = known_;
          now[level] = *admission;
          take(std::move(now));
        }
        done(admission ? Result<void>() : tl::unexpected(admission.error()));
      });
}

}  // namespace insonate::train
