#include "Classroom.h"
#include "class/ClassTable.h"
#include "person/HistoryTable.h"
#include "person/PersonCharts.h"

#include <insonate/curriculum/OpeningStore.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/Chart.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <fstream>

namespace insonate::review {
namespace {

class PersonPageTest : public Classroom {
 protected:
  /// Ina opens Anna from the class.
  void showAnna() {
    enter("ina");
    auto& table = *child<QTableView>("classTable");
    for (int row = 0; row < table.model()->rowCount(); ++row)
      if (table.model()->index(row, 0).data(ClassTable::kPerson).toString().toStdString() == school_->anna.id)
        table.setCurrentIndex(table.model()->index(row, 0));
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_Return);
    settle();
  }
  QTableWidget& history() { return *child<QTableWidget>("history"); }
  const ui::ChartContents& chart(const char* name) { return child<ui::Chart>(name)->picture(); }
  void choose(const char* name, const QString& text) {
    auto& box = *child<QComboBox>(name);
    box.setCurrentIndex(box.findText(text));
    Q_EMIT box.activated(box.currentIndex());
  }
};

TEST_F(PersonPageTest, ShowsWhereSomeoneIsAndHowTheyLearn) {
  practise(school_->as(school_->anna), false, 4);
  practise(school_->as(school_->anna), true);
  showAnna();
  const QString sentence = child<QLabel>("personSentence")->text();
  EXPECT_TRUE(sentence.contains("First jugular line")) << sentence.toStdString();
  EXPECT_TRUE(sentence.contains("1 of 2 passed attempts in a row")) << sentence.toStdString();
  choose("metricShown", "Needle path, mm");
  ASSERT_FALSE(chart("learningChart").isEmpty());
  EXPECT_EQ(chart("learningChart").bands.front().name, "expert");
  EXPECT_EQ(chart("learningChart").lines.back().points.size(), 5U);
  EXPECT_TRUE(chart("placeChart").isEmpty());
  EXPECT_TRUE(chart("placeChart").words.startsWith("n/a: fewer than 4 people"));
}

TEST_F(PersonPageTest, EnterOnAPersonLeadsToTheAttempts) {
  practise(school_->as(school_->anna), true, 2);
  showAnna();
  EXPECT_EQ(workspace_->statusText(), "Choose an attempt; Enter replays it.");
  EXPECT_EQ(workspace_->focusWidget(), &history()) << "Enter replays the first attempt";
}

TEST_F(PersonPageTest, LcCusumIsDrawnOnlyWhereTheLevelAsksForIt) {
  practise(school_->as(school_->anna), true);
  const Level& test = *curriculum_.level("jugular_test");
  practiseAt(test, school_->as(school_->anna), true);  // practice, which the curve leaves out: the test is not open
  test::valueOf(OpeningStore(school_->as(school_->ina))
                    .open({.cohort = school_->spring.id,
                           .level = test.name,
                           .end_us = services().now_us() + 3600 * test::kSecond_us}));
  practiseAt(test, school_->as(school_->anna), false, 2);
  practiseAt(test, school_->as(school_->anna), true, 2);
  showAnna();
  choose("levelShown", "First jugular line");
  EXPECT_TRUE(chart("cusumChart").isEmpty());
  EXPECT_EQ(chart("cusumChart").words,
            "n/a: this level does not use the LC-CUSUM; the level is mastered after 2 passed attempts in a row.");
  choose("levelShown", QString::fromStdString(test.title));
  const ui::ChartContents& cusum = chart("cusumChart");
  ASSERT_EQ(cusum.lines.size(), 2U) << cusum.words.toStdString();
  EXPECT_EQ(cusum.title, "LC-CUSUM: mastery needs at least 11 attempts")
      << "three in a row alone reach no limit of 4.07";
  EXPECT_EQ(cusum.lines[1].name, "limit 4.07; failure rate: 10 % acceptable, 40 % unacceptable");
  ASSERT_EQ(cusum.lines[0].points.size(), 4U);
  EXPECT_EQ(cusum.lines[0].points[1].y(), 0) << "failures keep it at 0";
  EXPECT_NEAR(cusum.lines[0].points[3].y(), 2 * std::log(0.9 / 0.6), 1e-9) << "two passes";
  EXPECT_EQ(chart("learningChart").lines.back().points.back().x(), cusum.lines[0].points.back().x())
      << "an attempt has one number";
  EXPECT_EQ(cusum.xTitle, chart("learningChart").xTitle);
}

TEST_F(PersonPageTest, TheLastAttemptsBesideTheClassAreThoseAtLevels) {
  for (const Person& one : {school_->ben, school_->anna}) practise(school_->as(one), true);
  practise(school_->as(school_->add("cleo", Role::Trainee, school_->spring.id)), true);
  practise(school_->as(school_->add("dora", Role::Trainee, school_->spring.id)), true);
  practise(school_->as(school_->anna), false);
  showAnna();
  EXPECT_EQ(chart("placeChart").xTitle, "last 10 attempts at levels");
  for (const char* metric : {"Needle path, mm", "Points"}) {
    choose("metricShown", metric);
    EXPECT_FALSE(chart("placeChart").isEmpty()) << metric << ": " << chart("placeChart").words.toStdString();
  }
}

TEST_F(PersonPageTest, ANewAttemptAppearsByItselfAndTheSelectedOneStaysSelected) {
  const SignedIn anna = school_->as(school_->anna);
  practise(anna, true, 2);
  showAnna();
  ASSERT_EQ(history().rowCount(), 2);
  history().selectRow(1);
  const QString date = history().item(1, 0)->text();
  QTest::mouseClick(child<QPushButton>("voidAttempt"), Qt::LeftButton);
  QTest::keyClicks(child<QLineEdit>("voidReason"), "the device");
  practise(anna, false);
  ASSERT_TRUE(QTest::qWaitFor([&] { return history().rowCount() == 3; }, kPatience_ms));
  EXPECT_EQ(history().currentRow(), 2);
  EXPECT_EQ(history().item(2, 0)->text(), date);
  EXPECT_EQ(child<QLineEdit>("voidReason")->text(), "the device");
  EXPECT_TRUE(child<QLineEdit>("voidReason")->isVisible());
  history().selectRow(0);
  EXPECT_FALSE(child<QLineEdit>("voidReason")->isVisible()) << "the reason was that of another attempt";
}

TEST_F(PersonPageTest, TheListFollowsTheLevelAndTheArrowsGoThroughTheClass) {
  practise(school_->as(school_->anna), true, 2);
  practiseAt(*curriculum_.level("jugular_alone"), school_->as(school_->anna), true);
  showAnna();
  const auto listed = [&] {
    int rows = 0;
    for (int row = 0; row < history().rowCount(); ++row) rows += !history().isRowHidden(row);
    return rows;
  };
  choose("levelShown", "First jugular line");
  EXPECT_EQ(listed(), 2);
  EXPECT_FALSE(history().isRowHidden(history().currentRow()));
  choose("levelShown", "All attempts");
  EXPECT_EQ(listed(), 3);
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr anna");
  QTest::keyClick(workspace_.get(), Qt::Key_Right, Qt::AltModifier);
  settle();
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr ben");
  child<QPushButton>("previousPerson")->click();
  settle();
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr anna");
}

TEST_F(PersonPageTest, ATraineeHasNoChartOfTheClass) {
  practise(school_->as(school_->anna), true, 2);
  enter("anna");
  ASSERT_TRUE(QTest::qWaitFor([&] { return history().rowCount() == 2; }, kPatience_ms));
  EXPECT_FALSE(isSeen("placeChart"));
  EXPECT_FALSE(isSeen("nextPerson"));
}

TEST_F(PersonPageTest, StandsBesideTheClass) {
  const auto& all = MetricCatalog::instance().all();
  const auto path = *std::ranges::find(all, "needle_path_mm", &MetricMeaning::id);
  /// Position of the third of these people.
  const auto placeAmong = [&](const std::vector<double>& paths_mm) {
    PersonFacts facts;
    facts.person.id = "p2";
    std::vector<AttemptFacts> last;
    for (const double path_mm : paths_mm) {
      AttemptFacts one;
      one.person = "p" + std::to_string(last.size()), one.state = AttemptState::Completed;
      one.procedure = "internal_jugular", one.metrics = {{"needle_path_mm", 1, path_mm}};
      last.push_back(one);
    }
    return placeInClass(facts, heatMapOf(last), path);
  };
  const ui::ChartContents picture = placeAmong({0, 10, 20, 30, 40});
  ASSERT_EQ(picture.boxes.size(), 1U);
  EXPECT_EQ(picture.boxes[0].numbers.median, 20);
  EXPECT_EQ(picture.lines[0].points[0].y(), 20);
  EXPECT_EQ(picture.lines[0].name, "better than 50 % of the others") << "a short way is a good one";
  EXPECT_EQ(placeAmong({30, 30, 10, 30, 30}).lines[0].name, "better than 100 % of the others");
  EXPECT_EQ(placeAmong({20, 10, 20, 30, 20}).lines[0].name, "better than 25 % of the others, equal to 50 % of them");
  EXPECT_EQ(placeAmong({20, 20, 20, 20, 20}).lines[0].name, "equal to all others in the class")
      << "and better than nobody";
}

TEST_F(PersonPageTest, AnAttemptIsVoidedWithAReason) {
  practise(school_->as(school_->anna), true, 2);
  showAnna();
  ASSERT_EQ(history().rowCount(), 2);
  EXPECT_EQ(history().item(0, 2)->text(), "Passed");
  QTest::keyClick(&history(), Qt::Key_Delete);
  auto& reason = *child<QLineEdit>("voidReason");
  ASSERT_TRUE(QTest::qWaitFor([&] { return reason.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(child<QLabel>("changeQuestion")->text().startsWith("Void the attempt of " + history().item(0, 0)->text()))
      << child<QLabel>("changeQuestion")->text().toStdString();
  EXPECT_FALSE(child<QPushButton>("voidNow")->isEnabled()) << "not without a reason";
  QTest::keyClick(&reason, Qt::Key_Return);
  settle();
  EXPECT_EQ(history().item(0, 2)->text(), "Passed");
  QTest::keyClicks(&reason, "<b>wrong</b> patient");
  QTest::keyClick(&reason, Qt::Key_Return);
  settle();
  EXPECT_EQ(history().item(0, 2)->text(), "Voided: <b>wrong</b> patient");
  EXPECT_EQ(history().item(1, 2)->text(), "Passed");
  EXPECT_FALSE(child<QPushButton>("voidAttempt")->isEnabled()) << "once only";
  EXPECT_EQ(test::valueOf(AttemptStore(school_->admin).attempt(last_.id)).voidReason, "<b>wrong</b> patient");
}

TEST_F(PersonPageTest, AnImplausibleAttemptIsMarkedForTheInstructorAlone) {
  practise(school_->as(school_->anna), true);
  practiseTooFast();
  showAnna();
  EXPECT_EQ(history().item(0, 2)->text(), "Passed   ▲ implausibly fast: time to vein 1.5\u00a0s")
      << "it passes all the same";
  EXPECT_EQ(history().item(1, 2)->text(), "Passed");
  workspace_.reset();
  account_.reset();
  enter("anna");
  EXPECT_EQ(history().item(0, 2)->text(), "Passed");
}

TEST_F(PersonPageTest, AKeptRecordingIsReplayed) {
  practise(school_->as(school_->anna), true);
  const std::filesystem::path kept = store_->recordings() / (last_.id + ".attempt");
  std::filesystem::create_directory(store_->recordings());
  std::ofstream(kept) << "the recording";
  showAnna();
  EXPECT_EQ(history().item(0, 5)->text(), "in the database");
  EXPECT_TRUE(child<QPushButton>("replayAttempt")->isEnabled());
  EXPECT_EQ(ui::findRecordingFile(test::valueOf(AttemptStore(school_->admin).attempt(last_.id)), file()).toStdString(),
            kept.string());
}

TEST_F(PersonPageTest, AnAttemptThatNothingProvesIsAcceptedWithAReason) {
  practise(school_->as(school_->anna), true);
  practise(school_->as(school_->anna), true, 1, AttemptProof::Unproven);
  showAnna();
  ASSERT_EQ(history().rowCount(), 2);
  EXPECT_EQ(history().item(0, 2)->text(), "Would pass, not proven; does not count");
  history().selectRow(1);
  auto& accept = *child<QPushButton>("acceptAttempt");
  EXPECT_FALSE(accept.isVisible()) << "this one is proven";
  history().selectRow(0);
  ASSERT_TRUE(accept.isVisible());
  accept.click();
  auto& reason = *child<QLineEdit>("voidReason");
  ASSERT_TRUE(QTest::qWaitFor([&] { return reason.isVisible(); }, kPatience_ms));
  QTest::keyClicks(&reason, "I watched it");
  QTest::keyClick(&reason, Qt::Key_Return);
  settle();
  EXPECT_EQ(history().item(0, 2)->text(), "Passed, accepted");
  EXPECT_FALSE(accept.isVisible());
  EXPECT_EQ(test::valueOf(AttemptStore(school_->admin).attempt(last_.id)).facts.proof, AttemptProof::Accepted);
}

TEST_F(PersonPageTest, EscapeLeavesAnAttemptAlone) {
  practise(school_->as(school_->anna), true);
  showAnna();
  child<QPushButton>("voidAttempt")->click();
  QTest::keyClick(child<QLineEdit>("voidReason"), Qt::Key_Escape);
  EXPECT_FALSE(child<QLineEdit>("voidReason")->isVisible());
  EXPECT_EQ(history().item(0, 2)->text(), "Passed");
}

TEST_F(PersonPageTest, ReplaysWhatIsHereAndSaysWhereTheRestIs) {
  practise(school_->as(school_->anna), true);
  showAnna();
  EXPECT_FALSE(child<QPushButton>("replayAttempt")->isEnabled());
  EXPECT_EQ(history().item(0, 5)->text(), "on ward 7");
  EXPECT_TRUE(
      child<QLabel>("historyWords")->text().contains("is not on this computer but on ward 7. Copy the recording"));
  const QSignalSpy failed(workspace_.get(), &ui::Workspace::failed);
  QTest::keyClick(&history(), Qt::Key_Return);
  EXPECT_EQ(failed.count(), 1);
  ASSERT_TRUE(QDir().mkpath(ui::attemptsFolder()));
  QFile recording(QDir(ui::attemptsFolder()).filePath(QString::fromStdString(last_.recording)));
  ASSERT_TRUE(recording.open(QIODevice::WriteOnly));
  EXPECT_EQ(ui::findRecordingFile(last_.recording, file()), recording.fileName());
  EXPECT_EQ(ui::findRecordingFile("../" + last_.recording, file()), "") << "never out of the folder";
  EXPECT_EQ(ui::findRecordingFile("/etc/passwd", file()), "");
  recording.remove();
}

TEST_F(PersonPageTest, ATraineeSeesThemselvesAndVoidsNothing) {
  practise(school_->as(school_->anna), true, 2);
  enter("anna");
  EXPECT_FALSE(isSeen("classTab"));
  EXPECT_EQ(child<QLabel>("personName")->text(), "Dr anna");
  EXPECT_EQ(history().rowCount(), 2);
  EXPECT_FALSE(child<QPushButton>("voidAttempt")->isVisible());
  EXPECT_TRUE(chart("placeChart").words.contains("you are no instructor of the class"));
  QTest::keyClick(workspace_.get(), Qt::Key_4, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return isSeen("attemptsWords"); }, kPatience_ms));
  QTest::keyClick(workspace_.get(), Qt::Key_2, Qt::AltModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return isSeen("history"); }, kPatience_ms));
}

TEST_F(PersonPageTest, MoreAttemptsThanAPageAreReadWhenRequested) {
  practise(school_->as(school_->anna), true, kPage + 3);
  showAnna();
  EXPECT_EQ(history().rowCount(), kPage);
  ASSERT_TRUE(isSeen("earlierAttempts"));
  child<QPushButton>("earlierAttempts")->click();
  settle();
  EXPECT_EQ(history().rowCount(), kPage + 3);
  EXPECT_FALSE(isSeen("earlierAttempts"));
}

TEST_F(PersonPageTest, WithoutAttemptsEachPlaceSaysWhatToDo) {
  showAnna();
  for (const char* name : {"learningChart", "cusumChart", "placeChart"})
    EXPECT_TRUE(chart(name).words.startsWith("n/a")) << name << ": " << chart(name).words.toStdString();
  EXPECT_TRUE(child<QLabel>("historyWords")->text().contains("No attempts yet"));
}

}  // namespace
}  // namespace insonate::review
