#include "LevelWindow.h"
#include "levels/LevelWords.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <gmock/gmock.h>

#include <QFile>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableWidget>
#include <future>

namespace insonate::train {
namespace {

using State = AttemptControl::State;

class TrainLevel : public LevelWindow {
 protected:
  QListWidget& path() { return *child<QListWidget>("levels"); }
  /// Opened and chosen by keys alone.
  void practise(int row) {
    if (!workspace_->findChild<QWidget*>("course") || !shown("course")) key(Qt::Key_J);
    path().setFocus();
    path().setCurrentRow(row);
    QTest::keyClick(&path(), Qt::Key_Return);
  }
};

TEST_F(TrainLevel, AGuestLooksAndPractisesFreelyAndNothingIsStored) {
  openWide();
  key(Qt::Key_J);
  ASSERT_TRUE(shown("course"));
  EXPECT_FALSE(shown("ultrasoundView"));
  EXPECT_TRUE(text("courseNote").contains("You are a guest")) << text("courseNote").toStdString();
  ASSERT_GT(path().count(), 1) << "of the curriculum that comes along";
  EXPECT_TRUE(path().item(0)->text().contains("unlocked"));
  path().setCurrentRow(1);
  EXPECT_TRUE(text("levelWhy").contains("Locked: master")) << text("levelWhy").toStdString();
  EXPECT_FALSE(child<QPushButton>("levelPractise")->isEnabled());
  QTest::keyClick(&path(), Qt::Key_Return);
  EXPECT_FALSE(levels_->level()) << "it can be looked at";
  EXPECT_TRUE(workspace_->statusText().contains("Locked: master")) << workspace_->statusText().toStdString();
  QTest::keyClick(&path(), Qt::Key_Escape);
  EXPECT_FALSE(shown("course"));
  EXPECT_TRUE(shown("ultrasoundView"));

  makeAttempt();
  EXPECT_TRUE(text("levelChanges").contains("does not count at any level")) << text("levelChanges").toStdString();
  EXPECT_TRUE(QFileInfo::exists(attempt_->file()));
  EXPECT_EQ(attempt_->header().recordedFor, RecordedFor{});
  EXPECT_TRUE(unsent().isEmpty());
  EXPECT_TRUE(stored().empty());
}

TEST_F(TrainLevel, AWholeOneFromChoosingItToTheNextThatOpens) {
  signIn();
  practise(0);
  EXPECT_EQ(wanted_, QStringList{home_.filePath("wide")});
  EXPECT_TRUE(levels_->waitsForCase());
  EXPECT_TRUE(text("attemptUnfit").contains("needs the case 'Wide block'")) << text("attemptUnfit").toStdString();
  openWide();
  EXPECT_FALSE(levels_->waitsForCase());
  EXPECT_EQ(text("levelTitle"), "The first one");
  EXPECT_TRUE(text("levelRule").contains("without a critical error")) << text("levelRule").toStdString();
  EXPECT_FALSE(shown("attemptProcedure"));
  EXPECT_EQ(attempt_->assistance(), Assistance::Guided);
  EXPECT_EQ(model_->imaging.tissue().body.tilt_deg, 15) << "as the level wants it";

  makeAttempt();
  EXPECT_TRUE(text("levelVerdict").contains("Passed")) << text("levelVerdict").toStdString();
  EXPECT_TRUE(text("levelStandards").contains("2 of 2 standards met")) << text("levelStandards").toStdString();
  EXPECT_TRUE(text("levelChanges").contains("The level 'The second one' is unlocked now."))
      << text("levelChanges").toStdString();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty() && !stored().empty(); }));
  const AttemptFacts facts = stored().front().facts;
  EXPECT_EQ(facts.level, "first");
  EXPECT_EQ(facts.curriculum, "course");
  EXPECT_EQ(facts.proof, AttemptProof::Proven) << "its recording has the store's nonce and codes";
  EXPECT_EQ(facts.state, AttemptState::Completed);
  EXPECT_TRUE(facts.succeeded);
  EXPECT_EQ(facts.recording, QFileInfo(attempt_->file()).fileName().toStdString());
  EXPECT_EQ(facts.recordingHash.size(), 64U);
  EXPECT_EQ(facts.metrics.size(), std::size_t(kMetricCount));
  EXPECT_GT(facts.length_us, 0);
  EXPECT_EQ(stored().front().recordingFile.string(),
            storeFile().toStdString() + ".recordings/" + facts.id + ".attempt");
  const auto checked = recomputeAttempts(at("admin"), {}, {});
  ASSERT_TRUE(checked) << checked.error().message;
  EXPECT_EQ(checked->compared, 1) << "the store's copy of the recording tells the same";
  for (const StoreDifference& one : checked->differences) ADD_FAILURE() << one.field << one.stored << one.expected;

  practise(1);
  EXPECT_TRUE(path().item(0)->text().contains("mastered")) << path().item(0)->text().toStdString();
  EXPECT_EQ(levels_->level()->name, "second");
  EXPECT_EQ(attempt_->state(), State::Idle) << "the result is left";
  EXPECT_EQ(attempt_->assistance(), Assistance::Hints);
  child<QPushButton>("levelLeave")->click();
  EXPECT_TRUE(shown("attemptProcedure"));
  makeAttempt();
  ASSERT_TRUE(waitFor([&] { return stored().size() == 2; }));
  EXPECT_EQ(stored().front().facts.level, "") << "free practice";
}

TEST_F(TrainLevel, PositionsAreNotOfferedWhileTheVeinHasToBeFound) {
  signIn();
  practise(0);
  openWide();
  EXPECT_TRUE(shown("positions"));
  attempt_->start();
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  EXPECT_FALSE(shown("positions")) << "they are refused";
  attempt_->finish();
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Over; }));
  EXPECT_TRUE(shown("positions"));
}

TEST_F(TrainLevel, ARecordingThatCannotBeCopiedCostsNoAttempt) {
  QFile blocking(storeFile() + ".recordings");
  ASSERT_TRUE(blocking.open(QIODevice::WriteOnly));
  QStringList said;
  QObject::connect(workspace_.get(), &ui::Workspace::statusChanged, [&] { said << workspace_->statusText(); });
  signIn();
  openWide();
  makeAttempt();
  ASSERT_TRUE(waitFor([&] { return !said.filter("The attempt counts; its recording stays").isEmpty(); }));
  ASSERT_EQ(stored().size(), 1U);
  EXPECT_TRUE(unsent().isEmpty());
  EXPECT_EQ(stored().front().facts.state, AttemptState::Completed);
  EXPECT_EQ(stored().front().recordingFile, "");
  EXPECT_EQ(ui::findRecordingFile(stored().front(), storeFile()), attempt_->file()) << "still replayed from there";
}

TEST_F(TrainLevel, WhatWasMissedIsSaidWithItsValue) {
  signIn();
  practise(0);
  openWide();
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  overTheVein();
  for (int pass = 0; pass < 2; ++pass) {
    type("needle_depth", "8");
    ASSERT_TRUE(waitFor([&] { return attempt_->view().metrics[Metric::Passes] == pass + 1; }));
    type("needle_depth", "-5");
    ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Used; }));
  }
  finish();
  EXPECT_TRUE(text("levelVerdict").contains("Not passed")) << text("levelVerdict").toStdString();
  EXPECT_TRUE(text("levelStandards").contains("passes: 2, at most 1")) << text("levelStandards").toStdString();
  EXPECT_TRUE(text("levelChanges").contains("Unlocked: no passed attempt yet")) << text("levelChanges").toStdString();
  EXPECT_FALSE(text("levelChanges").contains("because")) << "the list above states the reason";
}

TEST_F(TrainLevel, AttemptsThatAreLeftAreStoredAsAbandoned) {
  signIn();
  openWide();
  const auto begin = [&] {
    key(Qt::Key_Return, Qt::ControlModifier);
    ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  };
  begin();
  ASSERT_TRUE(waitFor([&] { return stored().size() == 1; }));
  EXPECT_EQ(stored().front().facts.state, AttemptState::Open) << "it has begun";
  EXPECT_TRUE(workspace_->interruptionWarning().contains("is saved as abandoned")) << "which the window asks about";
  workspace_->setCase(nullptr);
  EXPECT_EQ(workspace_->interruptionWarning(), "");
  ASSERT_TRUE(waitFor([&] { return stored().front().facts.state == AttemptState::Abandoned; }));

  openWide();
  begin();
  account_->signOut();
  EXPECT_FALSE(attempt_->isRunning()) << "signing out ends it";
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Idle; }));
  const auto isStored = [&] {
    const auto all = stored();
    return all.size() == 2 && all.front().facts.state == AttemptState::Abandoned;
  };
  ASSERT_TRUE(waitFor([&] { return !unsent().filter(QRegularExpression("^[^.]+[.]json$")).isEmpty() || isStored(); }))
      << "kept here, unless what was on its way to the store took it along";
  signIn();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty() && isStored(); }));

  begin();
  workspace_ = nullptr;
  account_ = nullptr;
  EXPECT_EQ(stored().size(), 3U);
  EXPECT_EQ(stored().front().facts.state, AttemptState::Abandoned) << "the program was closed";
  EXPECT_TRUE(unsent().isEmpty());
}

/// With the tip in the vein, which would be a pass had it been finished.
TEST_F(TrainLevel, AnAbandonedOneIsCalledSoInPanelAndHistory) {
  signIn();
  practise(0);
  openWide();
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  overTheVein();
  type("needle_depth", "12");
  ASSERT_TRUE(waitFor([&] { return attempt_->view().needle == NeedlePlace::Vein; }));
  child<QPushButton>("attemptAbandon")->click();
  ASSERT_TRUE(waitFor([&] { return attempt_->state() == State::Over; }));
  EXPECT_EQ(text("attemptHeadline"), "Abandoned");
  EXPECT_FALSE(attempt_->score().succeeded);
  EXPECT_TRUE(text("levelVerdict").contains("Not passed: it was abandoned")) << text("levelVerdict").toStdString();
  ASSERT_TRUE(waitFor([&] { return stored().size() == 1 && stored().front().facts.state == AttemptState::Abandoned; }));
  AttemptFacts facts = stored().front().facts;
  EXPECT_FALSE(facts.succeeded);
  EXPECT_EQ(outcomeOf(course_->curriculum(), facts), "abandoned");
  facts.succeeded = true;  // as stored by an older version
  EXPECT_EQ(outcomeOf(course_->curriculum(), facts), "abandoned");
  key(Qt::Key_J);
  key(Qt::Key_2, Qt::AltModifier);
  auto* history = child<QTableWidget>("history");
  ASSERT_TRUE(waitFor([&] { return history->rowCount() == 1; }));
  QStringList row;
  for (int column = 0; column < history->columnCount(); ++column) row << history->item(0, column)->text();
  EXPECT_TRUE(row.contains("abandoned")) << row.join(" | ").toStdString();
}

TEST_F(TrainLevel, WhatTheStoreRefusesIsKeptAndSentLater) {
  signIn();
  openWide();
  const SignedIn admin = at("admin");
  Person tess = account_->person();
  tess.disabled = true;
  ASSERT_TRUE(PeopleStore(admin).change(tess));
  QStringList said;
  QObject::connect(workspace_.get(), &ui::Workspace::statusChanged, [&] { said << workspace_->statusText(); });
  makeAttempt();
  ASSERT_TRUE(waitFor([&] { return !said.filter("kept on this computer and sent later").isEmpty(); }));
  EXPECT_EQ(unsent().size(), 1);

  tess.disabled = false;
  ASSERT_TRUE(PeopleStore(admin).change(tess));
  account_->signOut();
  signIn();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty(); }));
  ASSERT_EQ(stored().size(), 1U);
  EXPECT_EQ(stored().front().facts.state, AttemptState::Completed);
}

TEST_F(TrainLevel, AnEndIsOnDiskWhileAServerIsWaitedFor) {
  signIn();
  openWide();
  std::promise<void> answer;
  account_->query<void>(workspace_.get(),
                        [lost = answer.get_future().share()](const SignedIn&) -> Result<void> {
                          lost.wait();
                          return {};
                        },
                        {});
  makeAttempt();
  EXPECT_TRUE(waitFor([&] { return !unsent().filter(QRegularExpression("^[^.]*\\.json$")).isEmpty(); }));
  answer.set_value();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty(); }));
  ASSERT_EQ(stored().size(), 1U);
  EXPECT_EQ(stored().front().facts.state, AttemptState::Completed);
}

TEST_F(TrainLevel, AnotherCaseOrPersonLeavesTheLevel) {
  signIn();
  openWide();
  practise(0);
  ASSERT_TRUE(levels_->level());
  EXPECT_TRUE(wanted_.isEmpty()) << "its case is there already";
  workspace_->setCase(patient());
  EXPECT_FALSE(levels_->level());
  openWide();
  practise(0);
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  levels_->choose("first");
  EXPECT_TRUE(workspace_->statusText().contains("First finish or abandon the attempt"));
  account_->signOut();
  EXPECT_FALSE(levels_->level());
}

TEST_F(TrainLevel, ACaseThatIsSavedMeanwhileDoesNotChangeUnderALevel) {
  signIn();
  openWide();
  practise(0);
  ASSERT_TRUE(levels_->level());
  const auto before = model_->patientCase.patient();
  auto edited = std::make_shared<PatientCase>(*before);
  std::ranges::replace(edited->labels.voxels, std::uint8_t{kVein}, std::uint8_t{kMuscle});
  workspace_->caseSaved(edited);
  EXPECT_EQ(model_->patientCase.patient(), before) << "nobody is at an attempt, but the level is begun";
  EXPECT_TRUE(workspace_->statusText().contains("the former version")) << workspace_->statusText().toStdString();
  levels_->leave();
  EXPECT_TRUE(levels_->level() == nullptr);
}

TEST_F(TrainLevel, AnAuthorsDraftOfTheSameTitleIsNotTheLevelsCase) {
  const auto folder = std::filesystem::path(home_.filePath("wide").toStdString());
  openWide();
  const PatientCase wide = *model_->patientCase.patient();
  ASSERT_TRUE(saveCaseVersion(wide, folder, "2026-11-22", ""));
  ASSERT_TRUE(publishCase(wide, folder, "2026-11-22"));
  signIn();
  practise(0);
  EXPECT_TRUE(levels_->waitsForCase()) << "open is the author's folder, which may change";
  ASSERT_EQ(wanted_.size(), 1);
  EXPECT_EQ(wanted_[0].toStdString(), (folder / "versions" / "001").string());
  auto draft = std::make_shared<PatientCase>(wide);
  draft->labels.voxels[0] = kVein;
  workspace_->setOrigin({});  // not saved anywhere
  workspace_->setCase(draft);
  EXPECT_FALSE(levels_->level()) << "practised freely";
  practise(0);
  EXPECT_TRUE(levels_->waitsForCase());
  workspace_->setOrigin({{}, {}, false, home_.filePath("wide"), wanted_[0]});  // as the window opens a version
  workspace_->setCase(std::make_shared<const PatientCase>(wide));
  EXPECT_TRUE(levels_->level());
  EXPECT_FALSE(levels_->waitsForCase()) << "what was published";
}

TEST_F(TrainLevel, HintsSayOnlyWhatWentWrong) {
  openWide();
  attempt_->setAssistance(Assistance::Hints);
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning(); }));
  EXPECT_TRUE(waitFor([&] { return text("attemptDue").contains("No errors"); }));
  EXPECT_FALSE(shown("attemptNumbers"));
  EXPECT_FALSE(shown("attemptStepsLater"));
  EXPECT_TRUE(text("attemptHead").startsWith("Hints"));
  overTheVein();
  type("needle_depth", "22");
  EXPECT_TRUE(waitFor([&] { return text("attemptStanding").contains("through the posterior wall"); }));
  EXPECT_FALSE(shown("attemptDue"));
  attempt_->abandon();
}

}  // namespace
}  // namespace insonate::train
