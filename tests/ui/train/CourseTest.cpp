#include "LevelWindow.h"
#include "levels/LevelWords.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/ui/Chart.h>

#include <ui/support/AccessibleNames.h>

#include <QApplication>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QToolButton>
#include <algorithm>

namespace insonate::train {
namespace {

/// Texts that would harm whoever took them for markup, formats or file names.
const std::string kHostile =
    "<b>bold</b><img src='x'> %1 %2 & \"quotes\" ../../etc '; DROP TABLE attempts; -- \u202Eright to left\u202C "
    "\u0410dmin \U0001F489";

class TrainCourse : public LevelWindow {
 protected:
  void open(const char* tab) {
    if (!workspace_->findChild<QWidget*>("course") || !shown("course")) key(Qt::Key_J);
    child<QToolButton>(tab)->click();
  }
  QTableWidget& history() { return *child<QTableWidget>("history"); }
  QString cell(int row, int column) { return history().item(row, column)->text(); }

  /// `points` of attempts that ended, one a second. The level was published just now, and clocks may differ by ten
  /// minutes.
  void addAttempts(const std::vector<std::optional<double>>& points, const char* level = "first") {
    const SignedIn by = at(kTrainee);
    const AttemptStore store(by);
    for (const auto& value : points) {
      AttemptFacts facts;
      facts.curriculum = "course", facts.curriculumVersion = 1, facts.level = level;
      facts.procedure = "internal_jugular", facts.procedureVersion = 1, facts.caseName = kWideTitle;
      facts.begun_us = QDateTime::currentMSecsSinceEpoch() * 1000 + (++made_ - 500) * 1'000'000;
      const auto id = store.begin(facts);
      ASSERT_TRUE(id) << id.error().message;
      facts.id = *id, facts.state = AttemptState::Completed, facts.succeeded = true, facts.points = value;
      facts.proof = AttemptProof::Proven;
      facts.metrics = {{"artery_punctures", 1, 0.0}, {"passes", 1, 1.0}};
      const auto ended = store.end(facts);
      ASSERT_TRUE(ended) << ended.error().message;
    }
  }
  std::int64_t made_ = 0;
};

TEST_F(TrainCourse, OwnAttemptsAreListedNewestFirstAndOpened) {
  signIn();
  open("courseAttempts");
  EXPECT_TRUE(waitFor([&] { return text("historyWords").contains("You have no attempts yet"); }));
  addAttempts({40.0, std::nullopt, 80.0});
  openWide();
  child<QPushButton>("courseBack")->click();
  makeAttempt();
  open("courseAttempts");
  ASSERT_TRUE(waitFor([&] { return history().rowCount() == 4; }));
  EXPECT_EQ(cell(0, 2), "free practice");
  EXPECT_EQ(cell(1, 1), "The first one");
  EXPECT_EQ(cell(1, 2), "passed");
  EXPECT_EQ(cell(1, 3), "80");
  EXPECT_EQ(cell(2, 3), "n/a");

  QSignalSpy wanted(workspace_.get(), &ui::Workspace::attemptRequested);
  history().setFocus();
  history().selectRow(0);
  QTest::keyClick(&history(), Qt::Key_Return);
  ASSERT_EQ(wanted.count(), 1);
  EXPECT_EQ(wanted[0][0].toString().toStdString(), stored().front().recordingFile.string()) << "the store's copy";
  history().selectRow(1);
  child<QPushButton>("historyOpen")->click();
  EXPECT_EQ(wanted.count(), 1);
  EXPECT_TRUE(workspace_->statusText().contains("has no recording")) << workspace_->statusText().toStdString();

  account_->signOut();
  EXPECT_TRUE(waitFor([&] { return text("historyWords").contains("Sign in"); }));
  EXPECT_EQ(history().rowCount(), 0) << "nobody sees another's attempts";
}

TEST_F(TrainCourse, AnAttemptWhoseRecordingBrokeOffIsAbandonedAndSaysWhy) {
  addAttempts({80.0});
  const SignedIn by = at(kTrainee);
  const AttemptStore store(by);
  AttemptFacts facts = store.page(by.person().id, 1)->front().facts;
  facts.id.clear(), facts.succeeded = false, facts.points.reset(), facts.metrics.clear();
  const auto id = store.begin(facts);
  ASSERT_TRUE(id) << id.error().message;
  facts.id = *id, facts.state = AttemptState::Abandoned;
  const auto ended = store.end(facts);
  ASSERT_TRUE(ended) << ended.error().message;
  signIn();
  open("courseAttempts");
  ASSERT_TRUE(waitFor([&] { return history().rowCount() == 2; }));
  EXPECT_EQ(cell(0, 2), "abandoned");
  EXPECT_TRUE(history().item(0, 2)->toolTip().contains("Abandoned: the recording stopped early"))
      << history().item(0, 2)->toolTip().toStdString();
  EXPECT_FALSE(history().item(1, 2)->toolTip().contains("Abandoned"));
}

TEST_F(TrainCourse, UnreadCommentsAreCountedUntilTheyAreRead) {
  addAttempts({40.0, 80.0});
  const SignedIn tess = at(kTrainee);
  const std::string attempt = AttemptStore(tess).page(tess.person().id, 1)->front().facts.id;
  const auto written = CommentStore(at("admin")).add(attempt, 0, "Hold the probe still");
  ASSERT_TRUE(written) << written.error().message;
  signIn();
  open("courseAttempts");
  ASSERT_TRUE(waitFor([&] { return history().rowCount() == 2 && cell(0, 5) == "1, 1 unread"; }));
  EXPECT_EQ(cell(1, 5), "");
  EXPECT_EQ(text("historyWords"), "You have 1 unread comment. Open the attempt in Review to read the comment.");
  child<QPushButton>("courseBack")->click();
  ASSERT_TRUE(CommentStore(tess).markRead(attempt));
  open("courseAttempts");
  ASSERT_TRUE(waitFor([&] { return cell(0, 5) == "1"; }));
  EXPECT_FALSE(shown("historyWords"));
}

TEST(LevelWords, ALevelSaysHowManyAttemptsItTakesAtLeast) {
  Level level;
  level.mastery.consecutivePasses = 3;
  EXPECT_EQ(masteryOf(level), "3 consecutive passes");
  level.mastery.cusum = CusumRule{0.1, 0.4, 4.07};
  EXPECT_EQ(masteryOf(level),
            "3 consecutive passes; the learning curve score LC-CUSUM reaches 4.07; at least 11 attempts");
}

TEST_F(TrainCourse, MoreThanAPageOfAttemptsComesOnDemand) {
  addAttempts(std::vector<std::optional<double>>(230, 50.0));
  signIn();
  open("courseAttempts");
  ASSERT_TRUE(waitFor([&] { return history().rowCount() == 200 && child<QPushButton>("historyOlder")->isVisible(); }));
  child<QPushButton>("historyOlder")->click();
  ASSERT_TRUE(waitFor([&] { return history().rowCount() == 230; }));
  EXPECT_FALSE(shown("historyOlder"));
}

TEST_F(TrainCourse, ACurveIsDrawnForALevelAndAMetricAndSaved) {
  std::vector<std::optional<double>> points;
  for (int n = 1; n <= 12; ++n) points.emplace_back(90 - 60 / double(n) + (n % 2 ? 1 : -1));
  points[4] = std::nullopt;
  addAttempts(points);
  signIn();
  open("courseAttempts");
  auto* chart = child<ui::Chart>("curve");
  const auto named = [&](const QString& name) {
    const auto& lines = chart->picture().lines;
    return std::ranges::find(lines, name, &ui::ChartContents::Line::name);
  };
  ASSERT_NE(named("attempts"), chart->picture().lines.end()) << chart->picture().words.toStdString();
  EXPECT_EQ(named("attempts")->points.size(), 11) << "one tells no points";
  EXPECT_EQ(chart->picture().xTitle, "attempt number for this procedure, counting all levels and free practice");
  EXPECT_NE(named("learning curve"), chart->picture().lines.end());

  auto* of = child<QComboBox>("curveOf");
  const int second = of->findText("The second one");
  ASSERT_GT(second, 0);
  of->setCurrentIndex(second);
  Q_EMIT of->activated(second);
  EXPECT_TRUE(chart->picture().words.startsWith("n/a")) << chart->picture().words.toStdString();
  of->setCurrentIndex(0);
  Q_EMIT of->activated(0);
  auto* metric = child<QComboBox>("curveMetric");
  const int artery = metric->findText("Artery punctures");
  ASSERT_GT(artery, 0);
  metric->setCurrentIndex(artery);
  Q_EMIT metric->activated(artery);
  EXPECT_EQ(named("attempts")->points.size(), 12);
  EXPECT_FALSE(chart->picture().bands.empty()) << "the expert band";

  QSignalSpy written(workspace_.get(), &ui::Workspace::written);
  for (const char* ending : {"png", "svg", "pdf"}) {
    const QString file = home_.filePath(QStringLiteral("curve.") + ending);
    chart->save(file);
    EXPECT_GT(QFileInfo(file).size(), 500) << ending;
  }
  EXPECT_EQ(written.count(), 3);
}

TEST_F(TrainCourse, TheQuestionnaireIsFilledInKeptAsADraftAndStored) {
  open("courseQuestionnaire");
  EXPECT_TRUE(text("formWords").contains("Sign in"));
  EXPECT_FALSE(shown("formSend"));
  signIn();
  ASSERT_TRUE(shown("formSend"));
  child<QRadioButton>("form_head_realism_4")->setFocus();
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
  child<QPlainTextEdit>("form_head_realism_comment")->setFocus();
  QTest::keyClicks(QApplication::focusWidget(), "like a jelly");
  auto* years = child<QLineEdit>("form_years_since_residency");
  years->setText("100");
  child<QPushButton>("formSend")->click();
  EXPECT_TRUE(text("trouble_years_since_residency").contains("from 0 to 60"));
  EXPECT_TRUE(workspace_->statusText().contains("stated beside them"));

  account_->signOut();
  ASSERT_TRUE(waitFor([&] { return !shown("formSend"); }));
  EXPECT_FALSE(child<QRadioButton>("form_head_realism_4")->isChecked()) << "nobody sees another's answers";
  signIn();
  ASSERT_TRUE(waitFor([&] { return child<QRadioButton>("form_head_realism_4")->isChecked(); })) << "kept";
  EXPECT_EQ(child<QPlainTextEdit>("form_head_realism_comment")->toPlainText(), "like a jelly");
  child<QLineEdit>("form_years_since_residency")->setText("3");
  child<QPushButton>("formSend")->click();
  ASSERT_TRUE(waitFor([&] { return text("formWords").contains("Thank you"); })) << text("formWords").toStdString();
  const SignedIn tess = at(kTrainee);
  const auto forms = FormStore(tess).listByPerson(tess.person().id);
  ASSERT_TRUE(forms && forms->size() == 1);
  const auto answers = parseAnswers(forms->front().filled.answers);
  ASSERT_TRUE(answers);
  EXPECT_EQ(
      *answers,
      (FormAnswers{{"head_realism", "4"}, {"head_realism_comment", "like a jelly"}, {"years_since_residency", 3.0}}));
  EXPECT_FALSE(child<QRadioButton>("form_head_realism_4")->isChecked()) << "sent once";
}

TEST_F(TrainCourse, WhoSignsOutWhileSendingTheQuestionnaireFindsNoDraft) {
  open("courseQuestionnaire");
  signIn();
  ASSERT_TRUE(shown("formSend"));
  child<QRadioButton>("form_head_realism_4")->click();
  child<QPushButton>("formSend")->click();
  account_->signOut();
  ASSERT_TRUE(waitFor([&] { return !shown("formSend"); }));
  signIn();
  ASSERT_TRUE(waitFor([&] { return shown("formSend"); }));
  const SignedIn tess = at(kTrainee);
  EXPECT_EQ(FormStore(tess).listByPerson(tess.person().id)->size(), 1U);
  EXPECT_FALSE(child<QRadioButton>("form_head_realism_4")->isChecked()) << "it would be sent twice";
}

TEST_F(TrainCourse, KeysGoToThePageWhileItIsShown) {
  openWide();
  const Transform before = model_->motion.pose();
  key(Qt::Key_J);
  ASSERT_TRUE(shown("course"));
  auto* levels = child<QListWidget>("levels");
  EXPECT_TRUE(levels->hasFocus()) << QApplication::focusWidget()->objectName().toStdString();
  EXPECT_TRUE(workspace_->statusText().startsWith("Enter starts")) << workspace_->statusText().toStdString();
  QTest::keyClick(levels, Qt::Key_Down);
  EXPECT_EQ(levels->currentRow(), 1);
  QTest::keyClick(workspace_.get(), Qt::Key_Left);
  EXPECT_EQ(model_->motion.pose(), before) << "the probe is out of sight";
  QTest::keyClick(workspace_.get(), Qt::Key_J);
  EXPECT_FALSE(shown("course"));
  QTest::keyClick(workspace_.get(), Qt::Key_Left);
  EXPECT_NE(model_->motion.pose(), before);
}

class HostileCourse : public TrainCourse {
 protected:
  Curriculum curriculum() const override {
    Curriculum made = TrainCourse::curriculum();
    made.title = kHostile;
    for (Level& level : made.levels) {
      level.title = kHostile + level.name, level.about = kHostile;
      level.pass.standards[0].otherwise = kHostile;
    }
    return made;
  }
  std::string traineeName() const override { return "<i>Tess</i> & %1"; }
};

TEST_F(HostileCourse, NamesAreShownAsTheyAre) {
  signIn();
  open("courseLevels");
  const QString hostile = QString::fromStdString(kHostile);
  EXPECT_TRUE(text("courseHead").contains(hostile)) << text("courseHead").toStdString();
  EXPECT_EQ(text("levelHead"), hostile + "first");
  EXPECT_EQ(child<QLabel>("levelHead")->textFormat(), Qt::PlainText);
  EXPECT_TRUE(child<QListWidget>("levels")->item(0)->text().contains(hostile));
  levels_->choose("first");
  EXPECT_EQ(text("levelTitle"), hostile + "first");
  child<QPushButton>("courseBack")->click();
  openWide();
  makeAttempt();
  EXPECT_TRUE(text("levelChanges").contains("The level '" + hostile + "second' is unlocked now."))
      << text("levelChanges").toStdString();
  EXPECT_EQ(child<QLabel>("levelChanges")->textFormat(), Qt::PlainText);
  ASSERT_TRUE(waitFor([&] { return stored().size() == 1; }));
}

TEST_F(TrainCourse, EveryPageHasNamesAndTooltips) {
  signIn();
  for (const char* tab : {"courseLevels", "courseAttempts", "courseQuestionnaire"}) {
    open(tab);
    EXPECT_GT(test::expectNames(child<QWidget>("course"), true), 8) << tab;
  }
}

}  // namespace
}  // namespace insonate::train
