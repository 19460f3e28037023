#include "LevelWindow.h"

#include <insonate/curriculum/OpeningStore.h>

#include <ui/support/AccessibleNames.h>

#include <QDialog>
#include <QLineEdit>

namespace insonate::train {
namespace {

/// The trainee learns beside an instructor; the level "exam" is a test.
class TrainAdmission : public LevelWindow {
 protected:
  Curriculum curriculum() const override {
    Curriculum course = LevelWindow::curriculum();
    Level& exam = course.levels[1];
    exam.name = "exam", exam.title = "The test", exam.prerequisites.clear(), exam.assistance = Assistance::Test;
    return course;
  }
  void addInstructor() {
    const SignedIn admin = at("admin");
    const auto cohorts = CohortStore(admin).cohorts();
    ASSERT_TRUE(cohorts && cohorts->size() == 1);
    cohort_ = cohorts->front().id;
    ASSERT_TRUE(PeopleStore(admin).add({"ina", "Ina", "", Role::Instructor}, "first password", cohort_));
  }
  TestOpening openExam(const std::string& code) {
    return *OpeningStore(at("admin"))
                .open({.cohort = cohort_,
                       .level = "exam",
                       .end_us = QDateTime::currentMSecsSinceEpoch() * 1000 + 3'600'000'000,
                       .code = code});
  }
  void showExam() {
    if (!workspace_->findChild<QWidget*>("course") || !shown("course")) key(Qt::Key_J);
    child<QListWidget>("levels")->setCurrentRow(1);
    // By the course's next look at the store.
    course_->refresh();
  }
  bool waitForTest(const QString& words) {
    return waitFor([&] { return text("levelTest").contains(words); });
  }
  QDialog* entry() { return workspace_->findChild<QDialog*>("testEntry"); }

  std::string cohort_;
};

TEST_F(TrainAdmission, AClosedTestIsOfferedForPracticeAndDoesNotCount) {
  addInstructor();
  signIn();
  showExam();
  ASSERT_TRUE(waitForTest("has not opened this test")) << text("levelTest").toStdString();
  EXPECT_EQ(child<QPushButton>("levelPractise")->text(), "Practice this level");
  child<QPushButton>("levelPractise")->click();
  ASSERT_TRUE(entry());
  test::expectNames(entry(), true);
  EXPECT_FALSE(shown("testEntryCode")) << "there is no code to enter";
  child<QPushButton>("testEntryCancel")->click();
  EXPECT_FALSE(levels_->level());
  ASSERT_TRUE(waitFor([&] { return !entry(); }));
  child<QPushButton>("levelPractise")->click();
  child<QPushButton>("testEntryPractice")->click();
  ASSERT_TRUE(levels_->level());
  openWide();
  EXPECT_TRUE(text("levelTestState").contains("practice and does not count")) << text("levelTestState").toStdString();
  EXPECT_FALSE(shown("levelCode"));
  makeAttempt();
  EXPECT_TRUE(text("levelVerdict")
                  .contains("Practice, does not count: the test was not open. The attempt would have "
                            "passed"))
      << text("levelVerdict").toStdString();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty() && !stored().empty(); }));
  EXPECT_EQ(stored().front().facts.testConditions, TestConditions::Practice);
  EXPECT_EQ(course_->progressIn("exam")->attempts, 0);
}

TEST_F(TrainAdmission, AnOpenTestAsksForItsCodeAndCounts) {
  addInstructor();
  openExam("venus");
  signIn();
  showExam();
  ASSERT_TRUE(waitForTest("has opened this test with a code")) << text("levelTest").toStdString();
  child<QPushButton>("levelPractise")->click();
  ASSERT_TRUE(entry());
  EXPECT_TRUE(shown("testEntryCode"));
  child<QLineEdit>("testEntryCode")->setText("mars");
  child<QPushButton>("testEntryGo")->click();
  ASSERT_TRUE(waitFor([&] { return text("testEntrySaid").contains("The code is wrong"); }));
  EXPECT_FALSE(levels_->level());
  child<QLineEdit>("testEntryCode")->setText("Venus");
  QTest::keyClick(child<QLineEdit>("testEntryCode"), Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return levels_->level() && levels_->level()->name == "exam"; }));
  openWide();
  EXPECT_TRUE(text("levelTestState").contains("has opened this test until")) << text("levelTestState").toStdString();
  EXPECT_TRUE(shown("testWords")) << "the anatomy cannot be studied before the test begins";
  const Transform before = model_->motion.pose();
  key(Qt::Key_Right);
  EXPECT_EQ(model_->motion.pose(), before) << "nor scanned";
  EXPECT_TRUE(workspace_->statusText().startsWith("The test has not begun")) << workspace_->statusText().toStdString();
  makeAttempt();
  EXPECT_FALSE(shown("testWords"));
  EXPECT_TRUE(text("levelVerdict").contains("Passed")) << text("levelVerdict").toStdString();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty() && !stored().empty(); }));
  EXPECT_EQ(stored().front().facts.testConditions, TestConditions::Opened);
  EXPECT_EQ(course_->progressIn("exam")->attempts, 1);
}

/// The window last looked while the test was open; the store knows better.
TEST_F(TrainAdmission, TheStoreDecidesAndNotTheWindow) {
  addInstructor();
  const TestOpening opening = openExam("");
  signIn();
  showExam();
  ASSERT_TRUE(waitForTest("has opened this test until"));
  EXPECT_EQ(child<QPushButton>("levelPractise")->text(), "Take this test");
  child<QPushButton>("levelPractise")->click();
  ASSERT_TRUE(levels_->level()) << "nothing is asked";
  openWide();
  ASSERT_TRUE(OpeningStore(at("admin")).close(cohort_, opening.id));
  QTest::qWait(1100);  // a recording states its beginning in whole seconds
  makeAttempt();
  ASSERT_TRUE(waitFor([&] { return text("levelVerdict").contains("Practice, does not count"); }))
      << text("levelVerdict").toStdString();
  EXPECT_EQ(stored().front().facts.testConditions, TestConditions::Practice);
}

TEST_F(TrainAdmission, ATestWithoutAnInstructorIsTakenAlone) {
  signIn();
  showExam();
  ASSERT_TRUE(waitForTest("without an instructor: the attempt counts and is shown as self-administered"))
      << text("levelTest").toStdString();
  child<QPushButton>("levelPractise")->click();
  ASSERT_TRUE(levels_->level());
  openWide();
  makeAttempt();
  EXPECT_TRUE(text("levelVerdict").contains("Passed")) << text("levelVerdict").toStdString();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty() && !stored().empty(); }));
  EXPECT_EQ(stored().front().facts.testConditions, TestConditions::SelfAdministered);
}

}  // namespace
}  // namespace insonate::train
