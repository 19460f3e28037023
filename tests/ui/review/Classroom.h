#pragma once

#include "class/ClassController.h"
#include "home/ReviewHome.h"

#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/review/ReviewWorkspace.h>
#include <insonate/ui/Account.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <ui/support/Patience.h>
#include <unit/curriculum/StoreRig.h>

#include <QDateTime>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <atomic>
#include <memory>
#include <string>

namespace insonate::review {

using test::kPatience_ms;

/// Names of malicious trainees.
inline const std::string kHostileName =
    "<img src='x'> &amp; \"Robert'); DROP TABLE people;--\" %1 %2 \u0645\u0631\u062d\u0628\u0627";

/// The workspace by itself, over a school's store in a file: Ina teaches "Spring", where Anna and Ben learn by the
/// curriculum that comes along.
class Classroom : public testing::Test {
 protected:
  void SetUp() override {
    store_ = std::make_unique<CurriculumStore>(test::valueOf(CurriculumStore::open(file().toStdString(), services())));
    school_ = std::make_unique<test::School>(*store_);
    curriculum_ = test::valueOf(loadCurriculum("central_line"));
    test::valueOf(
        PublishedCurricula(school_->admin).publish(curriculum_.name, curriculum_.version, curriculumText(curriculum_)));
    test::succeed(CohortStore(school_->admin).setCurriculum(school_->spring.id, curriculum_.name, curriculum_.version));
  }
  void TearDown() override {
    workspace_.reset();
    account_.reset();
  }

  /// Or a server's address.
  virtual QString file() const { return home_.filePath("people.sqlite"); }
  /// By the clock of this computer, or later.
  StoreServices services() {
    return {.now_us = [this] { return QDateTime::currentMSecsSinceEpoch() * 1000 + later_us_; },
            .workstation = "ward 7",
            .passwordCost = PasswordCost::Minimum};
  }

  /// An attempt at the first level that passes, or fails by the artery.
  void practise(const SignedIn& by, bool well, int times = 1, AttemptProof proof = AttemptProof::Proven) {
    practiseAt(curriculum_.levels.front(), by, well, times, proof);
  }
  void practiseAt(const Level& level, const SignedIn& by, bool well, int times = 1,
                  AttemptProof proof = AttemptProof::Proven) {
    for (int i = 0; i < times; ++i) {
      AttemptFacts facts;
      facts.curriculum = curriculum_.name, facts.curriculumVersion = curriculum_.version, facts.level = level.name;
      facts.procedure = level.procedure, facts.procedureVersion = 1, facts.caseName = level.caseName;
      // Within the ten minutes by which clocks may differ: the level was published just now.
      facts.begun_us = services().now_us() - (++made_ % 500) * test::kSecond_us;
      facts.id = test::valueOf(AttemptStore(by).begin(facts));
      facts.length_us = 62'000'000, facts.state = AttemptState::Completed, facts.succeeded = well;
      facts.proof = proof;
      facts.criticalErrors = well ? 0 : 1, facts.points = well ? 84.0 : 0.0;
      for (const MetricStandard& one : level.pass.standards)
        if (std::ranges::none_of(facts.metrics, [&](const MetricFact& m) { return m.id == one.metric; }))
          facts.metrics.push_back({one.metric, one.version,
                                   one.maximum   ? *one.maximum
                                   : one.minimum ? *one.minimum
                                                 : 0});
      for (MetricFact& metric : facts.metrics)
        if (metric.id == "artery_punctures" && !well) metric.value = 2;
      facts.metrics.push_back({"passes", 1, 1.0});
      facts.metrics.push_back({"needle_path_mm", 1, 70.0 - made_ % 30});
      std::ranges::sort(facts.metrics, {}, &MetricFact::id);
      facts.metrics.erase(std::unique(facts.metrics.begin(), facts.metrics.end(),
                                      [](const auto& a, const auto& b) { return a.id == b.id; }),
                          facts.metrics.end());
      facts.recording = "2026-11-22 nobody's.attempt", facts.recordingHash = std::string(64, 'a');
      test::succeed(AttemptStore(by).end(facts));
      last_ = facts;
    }
  }

  /// Anna passes once more, with 1.5 s from skin to vein.
  void practiseTooFast() {
    AttemptFacts facts = last_;
    facts.id.clear(), facts.recording.clear(), facts.recordingHash.clear();
    std::erase_if(facts.metrics, [](const MetricFact& one) { return one.id == "time_to_vein_s"; });
    facts.metrics.push_back({"time_to_vein_s", 1, 1.5});
    test::valueOf(AttemptStore(school_->as(school_->anna)).add(facts));
  }

  /// Shows the workspace, to whom it may concern; "" for a guest.
  void enter(const std::string& name, QSize size = {1366, 700}) {
    account_ = std::make_unique<ui::Account>(file(), services());
    ASSERT_TRUE(QTest::qWaitFor([&] { return account_->state() != ui::Account::State::Opening; }, kPatience_ms));
    workspace_ = std::make_unique<ReviewWorkspace>(tasks_);
    workspace_->setAccount(*account_);
    workspace_->resize(size);
    workspace_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(workspace_.get()));
    workspace_->activateWindow();
    if (!name.empty()) signIn(name);
    settle();
  }
  void signIn(const std::string& name) {
    std::optional<Result<void>> in;
    account_->signIn(QString::fromStdString(name), QString::fromStdString(test::kPassword),
                     [&](const Result<void>& result) { in = result; });
    ASSERT_TRUE(QTest::qWaitFor([&] { return in.has_value(); }, kPatience_ms));
    ASSERT_TRUE(*in) << in->error().message;
  }
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  }
  template <class T>
  T* child(const char* name) {
    T* found = workspace_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  bool isSeen(const char* name) { return child<QWidget>(name)->isVisible(); }

  QTemporaryDir home_;
  std::unique_ptr<CurriculumStore> store_;
  std::unique_ptr<test::School> school_;
  Curriculum curriculum_;
  AttemptFacts last_;
  int made_ = 0;
  std::atomic<std::int64_t> later_us_ = 0;
  ui::TaskBar tasks_;
  std::unique_ptr<ui::Account> account_;
  std::unique_ptr<ReviewWorkspace> workspace_;
};

}  // namespace insonate::review
