#include "Classroom.h"
#include "ReviewSession.h"
#include "ReviewWindow.h"
#include "class/ClassTable.h"

#include <insonate/ui/Attempts.h>

#include <ui/support/PlainTexts.h>

#include <QDir>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

namespace insonate::review {
namespace {

/// A class, its people, its curriculum and the case of a recording are called what no one should be called.
class HostileClass : public Classroom {
 protected:
  void SetUp() override {
    Classroom::SetUp();
    const std::string name = test::kHostileText.toStdString(), endless = test::endlessText().toStdString();
    test::succeed(CohortStore(school_->admin).rename(school_->spring.id, name));
    for (Person person : {school_->anna, school_->ben, school_->ina}) {
      person.fullName = name;
      test::succeed(PeopleStore(school_->admin).change(person));
    }
    curriculum_.version += 1, curriculum_.title = endless;
    for (Level& level : curriculum_.levels) level.title = endless;
    test::valueOf(
        PublishedCurricula(school_->admin).publish(curriculum_.name, curriculum_.version, curriculumText(curriculum_)));
    test::succeed(CohortStore(school_->admin).setCurriculum(school_->spring.id, curriculum_.name, curriculum_.version));
    practise(school_->as(school_->anna), false, kStuckAfter);
    test::succeed(AttemptStore(school_->admin).voidAttempt(last_.id, endless.substr(0, 900)));
    practise(school_->as(school_->anna), false, kStuckAfter);
  }
  void show(const char* tab) {
    child<QToolButton>(tab)->click();
    settle();
    EXPECT_LE(workspace_->minimumSizeHint().width(), 1366) << tab;
    test::expectPlain(*workspace_);
  }
};

TEST_F(HostileClass, IsShownAsTextsOnEveryPage) {
  enter("ina");
  EXPECT_EQ(child<QTableView>("classTable")->model()->index(0, ClassTable::kName).data().toString(),
            test::kHostileText);
  EXPECT_GE(test::expectPlain(*workspace_), 1);
  auto& table = *child<QTableView>("classTable");
  table.setCurrentIndex(table.model()->index(0, 0));
  table.setFocus();
  QTest::keyClick(&table, Qt::Key_Return);
  settle();
  EXPECT_GE(test::expectPlain(*workspace_), 1) << "the person's name";
  for (const char* tab : {"compareTab", "ratersTab", "recordingsTab", "classTab"}) show(tab);
}

TEST_F(HostileClass, RecordingOfAHostileCaseIsShownAsText) {
  PatientCase patient = test::smallAttemptCase();
  patient.manifest.title = test::endlessText().toStdString();
  const auto script = readSessionScript(kTwoPasses, patient);
  ASSERT_TRUE(script) << script.error().message;
  ASSERT_TRUE(QDir().mkpath(ui::attemptsFolder()));
  const QString file = QDir(ui::attemptsFolder()).filePath("hostile" + ui::kAttemptSuffix);
  const auto outcome = runSession(*script, patient, "insonate test", file.toStdString(), {});
  ASSERT_TRUE(outcome) << outcome.error().message;
  enter("ina");
  show("recordingsTab");
  workspace_->openAttempt(file);
  auto* session = workspace_->findChild<ReviewSession*>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return session->attempt() && !session->isOpening(); }, kPatience_ms));
  EXPECT_GE(test::expectPlain(*workspace_), 1) << "the case's title";
  QDir(ui::attemptsFolder()).removeRecursively();
}

}  // namespace
}  // namespace insonate::review
