#include "Classroom.h"

#include <insonate/curriculum/OpeningStore.h>

#include <ui/support/AccessibleNames.h>

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>

namespace insonate::review {
namespace {

class Openings : public Classroom {
 protected:
  QString text(const char* label) { return child<QLabel>(label)->text(); }
  template <class Condition>
  bool waitFor(Condition condition) {
    return QTest::qWaitFor(condition, kPatience_ms);
  }
  /// By its key.
  void showDialog() {
    child<QTableView>("classTable")->setFocus();
    QTest::keyClick(child<QTableView>("classTable"), Qt::Key_T, Qt::AltModifier);
    ASSERT_TRUE(waitFor([&] { return workspace_->findChild<QDialog*>("openingDialog") != nullptr; }));
  }
  void press(const char* button) {
    child<QPushButton>(button)->click();
    settle();
  }
  QString cell(int row, int column) { return child<QTableWidget>("openings")->item(row, column)->text(); }
  TestAdmission admissionOf(const Person& person) {
    return test::valueOf(OpeningStore(school_->as(person)).admission(curriculum_.name, "jugular_test"));
  }
};

TEST_F(Openings, AnInstructorOpensATestWithACodeAndClosesIt) {
  enter("ina");
  EXPECT_TRUE(text("openTests").startsWith("○ No test is open: an attempt at a test is practice"))
      << text("openTests").toStdString();
  showDialog();
  test::expectNames(child<QDialog>("openingDialog"), true);
  EXPECT_EQ(child<QComboBox>("openingTest")->count(), 2) << "the tests alone";
  EXPECT_EQ(child<QComboBox>("openingWhom")->count(), 1) << "only administrators open tests for everyone";
  EXPECT_FALSE(child<QPushButton>("openingClose")->isEnabled());
  child<QCheckBox>("openingEnds")->setChecked(false);
  EXPECT_FALSE(child<QDateTimeEdit>("openingEnd")->isEnabled());
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return text("openingSaid").contains("neither an end nor a code"); }));
  child<QCheckBox>("openingEnds")->setChecked(true);
  child<QLineEdit>("openingCode")->setText("venus");
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return child<QTableWidget>("openings")->rowCount() == 1; }));
  EXPECT_EQ(cell(0, 0), "● open");
  EXPECT_EQ(cell(0, 1), child<QComboBox>("openingTest")->itemText(0));
  EXPECT_EQ(cell(0, 5), "venus") << "who has opened the test can look the code up";
  EXPECT_EQ(cell(0, 6), "Dr ina");
  EXPECT_EQ(child<QLineEdit>("openingCode")->text(), "");
  EXPECT_TRUE(text("openingSaid").endsWith("is open.")) << text("openingSaid").toStdString();
  EXPECT_TRUE(text("openTests").startsWith("● Tests that are open now: '")) << text("openTests").toStdString();
  EXPECT_TRUE(text("openTests").endsWith(", with a code (0 of 2 can take it)")) << text("openTests").toStdString();
  EXPECT_EQ(admissionOf(school_->anna).kind, TestAdmission::Kind::NeedsCode);
  press("openingClose");
  EXPECT_EQ(child<QPushButton>("openingClose")->text(), "Close for good");
  EXPECT_EQ(cell(0, 0), "● open") << "closing is asked about";
  press("openingClose");
  ASSERT_TRUE(waitFor([&] { return cell(0, 0) == "○ closed"; }));
  EXPECT_FALSE(child<QPushButton>("openingClose")->isEnabled()) << "closed once";
  EXPECT_TRUE(text("openTests").startsWith("○ No test is open"));
  EXPECT_EQ(admissionOf(school_->anna).kind, TestAdmission::Kind::Closed);
}

TEST_F(Openings, ASecondEnterDoesNotOpenTheTestWithoutItsCode) {
  enter("ina");
  showDialog();
  auto& code = *child<QLineEdit>("openingCode");
  code.setFocus();
  QTest::keyClicks(&code, "venus");
  QTest::keyClick(&code, Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return child<QTableWidget>("openings")->rowCount() == 1; }));
  settle();
  EXPECT_NE(QApplication::focusWidget(), &code);
  QTest::keyClick(&code, Qt::Key_Return);
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  settle();
  EXPECT_EQ(test::valueOf(OpeningStore(school_->as(school_->ina)).listByCohort(school_->spring.id)).size(), 1U);
  press("openingOpen");
  EXPECT_TRUE(text("openingSaid").contains("is open already")) << text("openingSaid").toStdString();
  EXPECT_EQ(test::valueOf(OpeningStore(school_->as(school_->ina)).listByCohort(school_->spring.id)).size(), 1U);
  EXPECT_EQ(admissionOf(school_->anna).kind, TestAdmission::Kind::NeedsCode);
  EXPECT_EQ(child<QPushButton>("openingOpen")->text(), "Open again");
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return child<QTableWidget>("openings")->rowCount() == 2; }));
}

TEST_F(Openings, TheDialogSaysHowManyCanTakeTheTest) {
  Curriculum open = curriculum_;
  open.version += 1;
  for (Level& level : open.levels)
    if (level.name == "jugular_test") level.prerequisites = {open.levels.front().name};
  test::valueOf(PublishedCurricula(school_->admin).publish(open.name, open.version, curriculumText(open)));
  test::succeed(CohortStore(school_->admin).setCurriculum(school_->spring.id, open.name, open.version));
  practise(school_->as(school_->anna), true, 3);
  enter("ina");
  showDialog();
  ASSERT_TRUE(waitFor([&] { return text("openingReady").contains("1 of 2 can take it"); }))
      << text("openingReady").toStdString();
  child<QComboBox>("openingTest")->setCurrentIndex(1);
  EXPECT_TRUE(text("openingReady").contains("0 of 2 can take it")) << text("openingReady").toStdString();
  EXPECT_TRUE(text("openingReady").startsWith("▲")) << "nobody could";
}

TEST_F(Openings, NoTestOfAnArchivedClassIsOffered) {
  test::succeed(CohortStore(school_->admin).archive(school_->spring.id, true));
  enter("ina");
  showDialog();
  EXPECT_FALSE(child<QPushButton>("openingOpen")->isEnabled());
  EXPECT_TRUE(text("openingSaid").contains("archived")) << text("openingSaid").toStdString();
}

TEST_F(Openings, ATestIsOpenedForALaterTime) {
  enter("ina");
  showDialog();
  const QDateTime start = QDateTime::currentDateTime().addDays(1);
  child<QDateTimeEdit>("openingStart")->setDateTime(start);
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return text("openingSaid").contains("State a later end."); })) << "the end is today";
  child<QDateTimeEdit>("openingEnd")->setDateTime(start.addSecs(3600));
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return child<QTableWidget>("openings")->rowCount() == 1; }));
  EXPECT_EQ(cell(0, 0), "◔ waiting");
  EXPECT_TRUE(text("openingSaid").endsWith("opens at its start time.")) << text("openingSaid").toStdString();
  EXPECT_TRUE(text("openTests").contains("◔ Tests that open later: '")) << text("openTests").toStdString();
  EXPECT_EQ(admissionOf(school_->anna).kind, TestAdmission::Kind::Closed);
  later_us_ = (24 * 3600 + 600) * test::kSecond_us;
  EXPECT_EQ(admissionOf(school_->anna).kind, TestAdmission::Kind::Open);
}

TEST_F(Openings, AnAdministratorOpensATestForEveryone) {
  enter("admin");
  EXPECT_FALSE(isSeen("classTests")) << "the class Autumn has no curriculum, so it has no tests";
  Q_EMIT child<QComboBox>("cohorts")->activated(1);
  settle();
  showDialog();
  child<QComboBox>("openingWhom")->setCurrentIndex(1);
  press("openingOpen");
  ASSERT_TRUE(waitFor([&] { return child<QTableWidget>("openings")->rowCount() == 1; }));
  EXPECT_EQ(cell(0, 2), "everyone");
  EXPECT_EQ(admissionOf(school_->carl).kind, TestAdmission::Kind::Open) << "of another class";
}

TEST_F(Openings, AttemptsOutsideAnOpeningArePracticeInThePersonsHistory) {
  const Level& exam = *curriculum_.level("jugular_test");
  practiseAt(exam, school_->as(school_->anna), true, 1, AttemptProof::Unproven);
  test::valueOf(OpeningStore(school_->as(school_->ina))
                    .open({.cohort = school_->spring.id, .level = exam.name, .code = "venus"}));
  test::valueOf(OpeningStore(school_->as(school_->anna)).enterCode(curriculum_.name, exam.name, "venus"));
  practiseAt(exam, school_->as(school_->anna), true);
  enter("anna");
  auto& history = *child<QTableWidget>("history");
  ASSERT_TRUE(waitFor([&] { return history.rowCount() == 2; }));
  EXPECT_EQ(history.item(0, 2)->text(), "Passed");
  EXPECT_EQ(history.item(1, 2)->text(), "Practice, the test was not open: would pass");
  EXPECT_FALSE(isSeen("classTests")) << "a trainee opens no tests";
}

}  // namespace
}  // namespace insonate::review
