#include "AccountWindow.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/Theme.h>

#include <gmock/gmock.h>
#include <support/SmallCase.h>
#include <ui/support/AccessibleNames.h>

#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QScreen>
#include <QScrollBar>
#include <algorithm>

namespace {

using namespace insonate;
using test::waitUntil;

/// Versions of the built-in curriculum, and of a draft that is begun from it.
QString builtIn() {
  return QString::number(loadCurriculum("central_line")->version);
}
QString next() {
  return QString::number(loadCurriculum("central_line")->version + 1);
}

/// An administrator writes the next version of what comes along.
class CurriculumWindowTest : public test::AccountWindow {
 protected:
  void SetUp() override {
    AccountWindow::SetUp();
    setUp();
    openWindow();
  }
  void openWindow() {
    action("accountLevels").trigger();
    dialog_ = dialogWith("curricula");
    ASSERT_TRUE(waitUntil([&] { return levels().count() > 0; }));
  }
  void beginDraft() {
    button("curriculumVersion").click();
    ASSERT_TRUE(waitUntil([&] { return state().startsWith("Draft"); })) << said();
  }
  template <class T>
  T& part(const char* name) {
    return *dialog_->findChild<T*>(name);
  }
  QPushButton& button(const char* name) { return part<QPushButton>(name); }
  QListWidget& levels() { return part<QListWidget>("curriculumLevels"); }
  QString state() { return part<QLabel>("curriculumState").text(); }
  QString story() { return part<QLabel>("levelStory").text(); }
  QString errors() { return part<QLabel>("curriculumTroubles").text(); }
  std::string said() { return part<QLabel>("curriculumWords").text().toStdString(); }
  std::string draftText() {
    return asked<std::string>([](const SignedIn& by) { return PublishedCurricula(by).draft("central_line"); })
        .value_or("");
  }
  Curriculum draft() { return parseDraft(draftText()).value_or(Curriculum()); }
  std::vector<std::string> titles() {
    std::vector<std::string> all;
    for (const Level& level : draft().levels) all.push_back(level.title);
    return all;
  }
  void untilSaved() {
    ASSERT_TRUE(waitUntil([&] { return state().endsWith(", saved"); })) << said();
  }

  QDialog* dialog_ = nullptr;
};

TEST_F(CurriculumWindowTest, TheWindowUsesTheScreenAndFitsIt) {
  const QSize screen = QGuiApplication::primaryScreen()->availableSize();
  EXPECT_LE(dialog_->width(), screen.width());
  EXPECT_LE(dialog_->height(), screen.height());
  EXPECT_GE(dialog_->height(), screen.height() * 85 / 100);
}

TEST_F(CurriculumWindowTest, WhatCannotBeChangedIsDrawnSo) {
  EXPECT_FALSE(part<QLineEdit>("levelEditTitle").isEnabled());
  const auto inkOf = [&] {
    auto& field = part<QLineEdit>("levelEditTitle");
    field.ensurePolished();
    return field.palette().color(QPalette::Disabled, QPalette::Text);
  };
  EXPECT_EQ(inkOf(), ui::toQColor(views::theme::kQuiet));
}

TEST_F(CurriculumWindowTest, WhatIsPublishedIsLookedAtAndNotChanged) {
  EXPECT_TRUE(state().contains("is published and cannot be changed")) << state().toStdString();
  EXPECT_EQ(levels().item(0)->text(), "1.  First jugular line");
  EXPECT_FALSE(part<QLineEdit>("levelEditTitle").isEnabled());
  EXPECT_FALSE(button("levelAdd").isEnabled());
  EXPECT_FALSE(button("curriculumPublish").isVisible());
  EXPECT_TRUE(story().contains(
      "Before the first attempt:  Unlocked: no attempt counts yet; 2 passed attempts in a row master it."))
      << story().toStdString();
  levels().setCurrentRow(1);
  EXPECT_TRUE(story().startsWith("Before the first attempt:  Locked: master 'First jugular line'"))
      << story().toStdString();
}

TEST_F(CurriculumWindowTest, ADraftIsWrittenToldPublishedAndTaught) {
  ASSERT_TRUE(asked<Cohort>([](const SignedIn& by) { return CohortStore(by).add("Autumn"); }));
  beginDraft();
  QTest::keyClicks(&part<QLineEdit>("levelEditTitle"), " & <b>%1</b>");
  EXPECT_EQ(levels().item(0)->text(), "1.  First jugular line & <b>%1</b>");
  part<QSpinBox>("passesInARow").setValue(4);
  EXPECT_TRUE(story().contains("4 passed attempts in a row master it")) << story().toStdString();
  part<QComboBox>("levelEditAssistance").setFocus();
  QTest::keyClick(&part<QComboBox>("levelEditAssistance"), Qt::Key_End);
  part<QCheckBox>("lapseDaysOn").click();
  EXPECT_TRUE(story().contains("After too many days without practice:  Lapsed: more than 180 days"))
      << story().toStdString();
  part<QDoubleSpinBox>("masteryPercent").setValue(98);
  untilSaved();
  const Curriculum kept = draft();
  const Level& level = kept.levels.front();
  EXPECT_EQ(kept.version, next().toInt());
  EXPECT_EQ(level.title, "First jugular line & <b>%1</b>");
  EXPECT_EQ(level.mastery.consecutivePasses, 4);
  EXPECT_EQ(level.assistance, Assistance::Test);
  EXPECT_EQ(level.mastery.lapsesAfter_days, 180);
  EXPECT_EQ(level.pass.mastery_percent, 98);

  button("curriculumPublish").click();
  dialogWith("entryGo")->findChild<QPushButton*>("entryGo")->click();
  ASSERT_TRUE(waitUntil([&] {
    return state() == "central_line, version " + next() +
                          " is published and cannot be changed. To make changes, begin a new version.";
  })) << state().toStdString()
      << said();
  EXPECT_EQ(draftText(), "") << "it is no draft any more";
  EXPECT_FALSE(part<QLineEdit>("levelEditTitle").isEnabled());
  ASSERT_TRUE(waitUntil([&] { return part<QComboBox>("curriculumCohort").count() == 1; }));
  button("curriculumTeach").click();
  ASSERT_TRUE(waitUntil([&] {
    return part<QComboBox>("curriculumCohort").currentText().endsWith("version " + next() + ")");
  })) << said();
}

TEST_F(CurriculumWindowTest, CasesThatAreOpenedOrDownloadedMeanwhileAreOffered) {
  beginDraft();
  const auto isOffered = [&](const char* title) { return part<QComboBox>("levelEditCase").findData(title) >= 0; };
  const QString folder = home.filePath("ward");
  ASSERT_TRUE(QDir().mkpath(folder));
  EXPECT_FALSE(isOffered("Neck of the ward"));
  QApplication::setActiveWindow(window.get());
  ui::rememberCase({folder, "Neck of the ward"});
  QApplication::setActiveWindow(dialog_);
  EXPECT_TRUE(waitUntil([&] { return isOffered("Neck of the ward"); }));
  ui::rememberCase({folder, "Neck from the server"});
  Q_EMIT account().casesDownloaded();
  EXPECT_TRUE(isOffered("Neck from the server"));
  EXPECT_FALSE(isOffered("Neck of the ward")) << "the case has another title now";
}

TEST_F(CurriculumWindowTest, CasesOfTheLibraryAreOfferedAndFound) {
  PatientCase ward = test::smallCase();
  ward.manifest.title = "Neck of the library";
  const QString library = home.filePath("library");
  ASSERT_TRUE(QDir().mkpath(library));
  ASSERT_TRUE(writeCase(ward, (library + "/ward").toStdString()));
  beginDraft();
  QApplication::setActiveWindow(window.get());
  ui::setLibraryFolders({library});
  EXPECT_EQ(ui::findCaseLocation("Neck of the library"), library + "/ward");
  QApplication::setActiveWindow(dialog_);
  EXPECT_TRUE(waitUntil([&] { return part<QComboBox>("levelEditCase").findData("Neck of the library") >= 0; }));
}

TEST_F(CurriculumWindowTest, KeysMoveALevel) {
  beginDraft();
  QApplication::setActiveWindow(dialog_);
  levels().setFocus();
  const std::vector<std::string> before = titles();
  ASSERT_GE(before.size(), 3U);
  QTest::keyClick(&levels(), Qt::Key_Down, Qt::ControlModifier);
  // A button is seen to go down for a moment before it acts.
  ASSERT_TRUE(waitUntil([&] { return levels().currentRow() == 1; })) << "the chosen level stays chosen";
  QTest::keyClick(&levels(), Qt::Key_Down, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([&] { return levels().currentRow() == 2; }));
  untilSaved();
  std::vector<std::string> moved = before;
  std::rotate(moved.begin(), moved.begin() + 1, moved.begin() + 3);
  EXPECT_EQ(titles(), moved);
}

TEST_F(CurriculumWindowTest, TheListOfPrerequisitesKeepsItsPlace) {
  beginDraft();
  levels().setCurrentRow(levels().count() - 1);
  auto& needs = part<QListWidget>("levelEditNeeds");
  needs.scrollToBottom();
  const int place = needs.verticalScrollBar()->value();
  ASSERT_GT(place, 0);
  QListWidgetItem* item = needs.item(needs.count() - 1);
  item->setCheckState(item->checkState() == Qt::Checked ? Qt::Unchecked : Qt::Checked);
  untilSaved();
  EXPECT_EQ(needs.verticalScrollBar()->value(), place) << "the next click would meet another level";
}

TEST_F(CurriculumWindowTest, WhatIsWrongIsToldWhereItIsAndKeepsItFromBeingPublished) {
  beginDraft();
  part<QListWidget>("levelEditNeeds").item(0)->setCheckState(Qt::Checked);
  EXPECT_TRUE(errors().contains("form a circle")) << errors().toStdString();
  EXPECT_FALSE(button("curriculumPublish").isEnabled());
  button("curriculumUndo").click();
  EXPECT_TRUE(button("curriculumPublish").isEnabled());
  auto& title = part<QLineEdit>("levelEditTitle");
  title.setFocus();
  title.selectAll();
  QTest::keyClick(&title, Qt::Key_Delete);
  EXPECT_TRUE(errors().contains("has no 'title'")) << errors().toStdString();
  EXPECT_TRUE(levels().item(0)->text().startsWith("▲")) << levels().item(0)->text().toStdString();
  untilSaved();
  EXPECT_EQ(draft().levels.front().title, "") << "what is not finished is kept as well";
  levels().setCurrentRow(3);
  EXPECT_TRUE(errors().contains("Errors in other levels (marked with ▲ in the list): 1")) << errors().toStdString();
}

TEST_F(CurriculumWindowTest, ItSurvivesClosingAndStepsAreTakenBack) {
  beginDraft();
  const int before = levels().count();
  button("levelAdd").click();
  EXPECT_EQ(levels().count(), before + 1);
  EXPECT_EQ(levels().currentRow(), before);
  QTest::keyClicks(&part<QLineEdit>("levelEditTitle"), "New");
  QTest::keyClicks(&part<QPlainTextEdit>("levelEditAbout"), "About it");
  button("curriculumUndo").click();
  EXPECT_EQ(part<QPlainTextEdit>("levelEditAbout").toPlainText(), "") << "one field is one step";
  button("curriculumUndo").click();
  button("curriculumRedo").click();
  EXPECT_EQ(part<QLineEdit>("levelEditTitle").text(), "New");
  button("levelUp").click();
  dialog_->close();
  ASSERT_TRUE(waitUntil([&] { return !window->findChild<QListWidget*>("curricula"); }));
  EXPECT_EQ(draft().levels[std::size_t(before - 1)].title, "New");
  openWindow();
  EXPECT_TRUE(state().startsWith("Draft of the curriculum central_line, version " + next()))
      << "drafts come first: " << state().toStdString();
  levels().setCurrentRow(before - 1);
  button("levelRemove").click();
  EXPECT_EQ(levels().count(), before);
  button("curriculumDiscard").click();
  dialogWith("entryGo")->findChild<QPushButton*>("entryGo")->click();
  ASSERT_TRUE(waitUntil([&] {
    return state().contains("version " + builtIn() + " is published and cannot be changed");
  })) << state().toStdString();
  EXPECT_EQ(draftText(), "");
}

TEST_F(CurriculumWindowTest, TwoWhoWriteAtOnceDoNotOverwriteEachOther) {
  beginDraft();
  const auto otherSaves = [&](const std::string& title) {
    Curriculum theirs = draft();
    theirs.title = title;
    const auto saved = asked<int>([text = curriculumText(theirs), before = draftText()](const SignedIn& by) {
      return PublishedCurricula(by).saveDraft("central_line", text, before).map([] { return 0; });
    });
    ASSERT_TRUE(saved) << saved.error().message;
  };
  otherSaves("Theirs");
  part<QSpinBox>("passesInARow").setValue(7);
  ASSERT_TRUE(waitUntil([&] { return button("curriculumMine").isVisible(); }));
  EXPECT_EQ(draft().title, "Theirs");
  button("curriculumTheirs").click();
  ASSERT_TRUE(waitUntil([&] { return part<QLineEdit>("curriculumTitle").text() == "Theirs"; }));
  EXPECT_FALSE(button("curriculumMine").isVisible());
  EXPECT_EQ(part<QSpinBox>("passesInARow").value(), 2);

  otherSaves("Theirs again");
  part<QSpinBox>("passesInARow").setValue(8);
  ASSERT_TRUE(waitUntil([&] { return button("curriculumMine").isVisible(); }));
  button("curriculumMine").click();
  untilSaved();
  EXPECT_EQ(draft().title, "Theirs");
  EXPECT_EQ(draft().levels.front().mastery.consecutivePasses, 8);
}

TEST_F(CurriculumWindowTest, TheLimitOfLcCusumIsCalibrated) {
  beginDraft();
  EXPECT_FALSE(button("cusumCalibrate").isEnabled());
  EXPECT_EQ(part<QLabel>("fewestAttempts").text(), "mastery takes at least 2 attempts");
  part<QCheckBox>("cusumOn").click();
  part<QDoubleSpinBox>("cusumAcceptable").setValue(10);
  part<QDoubleSpinBox>("cusumUnacceptable").setValue(25);
  part<QDoubleSpinBox>("cusumLimit").setValue(5);
  part<QDoubleSpinBox>("cusumFalse").setValue(10);
  button("cusumCalibrate").click();
  ASSERT_TRUE(waitUntil([&] { return part<QLabel>("cusumCalibrated").isVisible(); }));
  EXPECT_DOUBLE_EQ(part<QDoubleSpinBox>("cusumLimit").value(), 3.10) << "3.097, upward";
  const QString told = part<QLabel>("cusumCalibrated").text();
  EXPECT_TRUE(told.contains("within 50 attempts"));
  // By adding up all ways it is 8.9 % (LcCusumTest), which an interval of simulated careers holds.
  const QRegularExpressionMatch share =
      QRegularExpression("about ([0-9.]+) % \\(([0-9.]+) to ([0-9.]+) %\\) of trainees who fail 25 %").match(told);
  ASSERT_TRUE(share.hasMatch()) << told.toStdString();
  EXPECT_LT(share.captured(2).toDouble(), 8.9);
  EXPECT_GT(share.captured(3).toDouble(), 8.9);
  EXPECT_TRUE(story().contains("a learning score (LC-CUSUM) of 3.10: at least 18 attempts")) << story().toStdString();
  EXPECT_EQ(part<QLabel>("fewestAttempts").text(), "mastery takes at least 18 attempts");
  part<QDoubleSpinBox>("cusumUnacceptable").setValue(5);
  EXPECT_EQ(part<QLabel>("fewestAttempts").text(),
            "the two failure rates are too close to distinguish: raise the unacceptable rate");
  EXPECT_TRUE(errors().contains("below the 'unacceptable'")) << errors().toStdString();
  button("cusumCalibrate").click();
  EXPECT_TRUE(waitUntil([&] { return part<QLabel>("cusumCalibrated").text().contains("needs rates of failure"); }));
}

TEST_F(CurriculumWindowTest, StandardsAreAddedChangedAndRemoved) {
  beginDraft();
  auto& table = part<QTableWidget>("standards");
  const int before = table.rowCount();
  button("standardAdd").click();
  ASSERT_EQ(table.rowCount(), before + 1);
  EXPECT_EQ(table.currentRow(), before);
  EXPECT_TRUE(errors().contains("has no 'otherwise'")) << errors().toStdString();
  QTest::keyClicks(&part<QLineEdit>("standardOtherwise"), "it was <i>late</i>");
  part<QDoubleSpinBox>("standardLimit").setValue(5);
  EXPECT_EQ(row(table, before)[2], "it was <i>late</i>");
  EXPECT_EQ(row(table, before)[1], "at most 5");
  EXPECT_EQ(table.currentRow(), before) << "the choice stays while it is changed";
  button("standardRemove").click();
  EXPECT_EQ(table.rowCount(), before);
}

TEST_F(CurriculumWindowTest, ANewOneBeginsWithALevelThatIsToBeWritten) {
  button("curriculumNew").click();
  QDialog* entry = dialogWith("curriculumName");
  type(entry, "curriculumName", "a b");
  go(entry);
  ASSERT_TRUE(waitUntil([&] { return error(entry).contains("at most 64 letters"); })) << error(entry).toStdString();
  type(entry, "curriculumName", "central_line");
  go(entry);
  ASSERT_TRUE(waitUntil([&] { return error(entry).contains("already"); }));
  type(entry, "curriculumName", "pleural_taps");
  go(entry);
  ASSERT_TRUE(waitUntil([&] { return state().startsWith("Draft of the curriculum pleural_taps, version 1"); }))
      << said();
  EXPECT_EQ(levels().count(), 1);
  EXPECT_FALSE(button("curriculumPublish").isEnabled());
}

TEST_F(CurriculumWindowTest, EverythingHasANameAndATooltip) {
  beginDraft();
  part<QCheckBox>("cusumOn").click();
  EXPECT_GT(test::expectNames(dialog_, true), 40);
}

}  // namespace
