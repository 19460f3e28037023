#include "ReviewWindow.h"
#include "list/AttemptList.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/Phantom.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/Attempts.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/views/UltrasoundView.h>

#include <gmock/gmock.h>

#include <QApplication>
#include <QComboBox>
#include <QDate>
#include <QDir>
#include <QFile>
#include <QHelpEvent>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTableWidget>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>

namespace insonate::review {
namespace {

TEST_F(ReviewWindow, ShowsAnAttemptWithItsMomentsAndItsPicture) {
  openAll(recorded(home_.filePath("two")));
  EXPECT_EQ(child<QLabel>("attemptTitle")->text(), "Internal jugular vein with ultrasound");
  const QString facts = child<QLabel>("attemptFacts")->text();
  EXPECT_TRUE(facts.contains("Small block") && facts.contains("0:09.10") && facts.contains("completed"))
      << facts.toStdString();
  EXPECT_FALSE(child<QLabel>("attemptNotice")->isVisible());
  EXPECT_EQ(child<QListWidget>("moments")->count(), int(session_->attempt()->moments.size()));
  EXPECT_EQ(session_->fit(), CaseFit::Same);
  ASSERT_TRUE(session_->picture().shown());
  session_->setTime(2'000'000);
  settle();
  const auto& frame = session_->picture().shown();
  EXPECT_EQ(frame->patientFromProbe, *session_->sample()->patientFromProbe);
  ASSERT_TRUE(frame->needle);
  EXPECT_NEAR(frame->needle->tip_mm.y, 15, 0.5);
  EXPECT_EQ(session_->needle().place, NeedlePlace::Vein);
  EXPECT_TRUE(child<QLabel>("needlePlace")->text().contains("in the vein"));
  const QString hands = child<QLabel>("handsNow")->text();
  EXPECT_TRUE(hands.contains("inserted 15.") && hands.contains("depth 15.")) << hands.toStdString();
  session_->setTime(8'900'000);
  settle();
  EXPECT_FALSE(session_->picture().shown()) << "the probe is lifted";
}

TEST_F(ReviewWindow, AfterAJumpTheFormerImageIsMarkedAtOnce) {
  openAll(recorded(home_.filePath("two")));
  session_->setTime(2'000'000);
  settle();
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("replayPicture")->view());
  EXPECT_EQ(view.staleMark(), "");
  session_->setTime(2'100'000);
  EXPECT_EQ(view.staleMark(), "") << "as while it plays";
  settle();
  session_->setTime(6'000'000);
  EXPECT_EQ(view.staleMark(), "Image of another moment");
  settle();
  EXPECT_EQ(view.staleMark(), "");
  session_->setTime(8'900'000);
  EXPECT_EQ(view.staleMark(), "Image of another moment") << "the probe is lifted";
  settle();
  EXPECT_EQ(view.staleMark(), "") << "there is no image to be marked";
}

TEST_F(ReviewWindow, TheDateIsWholeInANarrowWindow) {
  workspace_->resize(1229, 600);
  openAll(recorded(home_.filePath("two")));
  const auto* date = child<QLabel>("attemptDate");
  EXPECT_TRUE(date->text().contains(QString::number(QDate::currentDate().year()))) << date->text().toStdString();
  EXPECT_GE(date->width(), date->sizeHint().width());
  EXPECT_EQ(date->visibleRegion().boundingRect(), date->rect());
}

TEST_F(ReviewWindow, TheStatusNamesTheVesselThatTheTipIsIn) {
  openAll(recorded(home_.filePath("named"), kTwoPasses, namedBlock()));
  session_->setTime(2'000'000);
  EXPECT_TRUE(child<QLabel>("needlePlace")->text().contains("in the right internal jugular vein"))
      << child<QLabel>("needlePlace")->text().toStdString();
  session_->setTime(2'690'000);
  EXPECT_TRUE(child<QLabel>("needlePlace")->text().contains("wrong place"));
  QStringList said;
  for (int row = 0; row < child<QListWidget>("moments")->count(); ++row)
    said << child<QListWidget>("moments")->item(row)->text();
  EXPECT_EQ(said.filter("The right internal jugular vein is reached.").size(), 1) << said.join('\n').toStdString();
}

TEST_F(ReviewWindow, ATimelineIsClickedDraggedAndMagnified) {
  openAll(recorded(home_.filePath("two")));
  Timeline& line = timeline();
  const int y = line.height() / 2;
  QTest::mouseClick(&line, Qt::LeftButton, {}, {line.xOf(3'000'000), y});
  EXPECT_NEAR(time_s(), 3, 0.03);
  QTest::mousePress(&line, Qt::LeftButton, {}, {line.xOf(1'000'000), y});
  QMouseEvent move(QEvent::MouseMove, QPoint(line.xOf(6'000'000), y), Qt::NoButton, Qt::LeftButton, {});
  QApplication::sendEvent(&line, &move);
  QTest::mouseRelease(&line, Qt::LeftButton, {}, {line.xOf(6'000'000), y});
  EXPECT_NEAR(time_s(), 6, 0.03);
  // A mark is hit beside its middle, and gives its exact time.
  const auto& moments = session_->attempt()->moments;
  const auto vein =
      std::ranges::find_if(moments, [](const auto& m) { return m.description.find("vein") != m.description.npos; });
  QTest::mouseClick(&line, Qt::LeftButton, {}, {line.xOf(vein->time_us) + 2, 8});
  EXPECT_EQ(session_->time_us(), vein->time_us);
  EXPECT_EQ(line.momentAt({line.xOf(vein->time_us), line.height() - 5}), -1) << "marks are at the top";
  const QPoint mark(line.xOf(vein->time_us), 8);
  QHelpEvent hover(QEvent::ToolTip, mark, line.mapToGlobal(mark));
  QApplication::sendEvent(&line, &hover);
  EXPECT_TRUE(QToolTip::text().contains(QString::fromStdString(vein->description))) << QToolTip::text().toStdString();
  // Magnified about the pointer, whose time stays under it.
  const QPoint at(line.xOf(4'000'000), y);
  QWheelEvent wheel(QPointF(at), line.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&line, &wheel);
  EXPECT_LT(line.last_us() - line.first_us(), session_->attempt()->end_us * 7 / 10);
  EXPECT_NEAR(line.xOf(4'000'000), at.x(), 2);
  session_->setTime(session_->attempt()->end_us);
  EXPECT_EQ(line.last_us(), session_->attempt()->end_us) << "it goes along";
  QTest::mouseDClick(&line, Qt::LeftButton, {}, at);
  EXPECT_EQ(line.first_us(), 0);
}

TEST_F(ReviewWindow, KeysStepPlayAndChoose) {
  openAll(recorded(home_.filePath("two")));
  key(Qt::Key_Period);
  EXPECT_NEAR(time_s(), 1.0 / 30, 1e-3);
  key(Qt::Key_Right);
  key(Qt::Key_Comma);
  EXPECT_NEAR(time_s(), 1, 1e-3);
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_EQ(session_->time_us(), session_->attempt()->end_us) << "not beyond the end";
  key(Qt::Key_Home);
  const auto& moments = session_->attempt()->moments;
  const auto first = std::ranges::find_if(moments, [](const auto& m) { return m.time_us > 0; });
  key(Qt::Key_PageDown);
  EXPECT_EQ(session_->time_us(), first->time_us);
  key(Qt::Key_End);
  key(Qt::Key_PageUp);
  EXPECT_EQ(session_->time_us(), moments.back().time_us);
  key(Qt::Key_Plus);
  EXPECT_EQ(session_->speed(), 2);
  EXPECT_EQ(child<QComboBox>("speed")->currentText(), "2 x");
  for (int i = 0; i < 6; ++i) key(Qt::Key_Minus);
  EXPECT_EQ(session_->speed(), 0.25);
  key(Qt::Key_2);
  EXPECT_TRUE(child<QWidget>("resultPage")->isVisible());
  key(Qt::Key_1);
  EXPECT_FALSE(child<QWidget>("resultPage")->isVisible());
  // The list of moments takes arrows for itself, where the table has nothing for them; the keys of the table it leaves.
  child<QListWidget>("moments")->setFocus();
  QTest::keyClick(child<QListWidget>("moments"), Qt::Key_Home);
  EXPECT_EQ(session_->time_us(), 0);
  key(Qt::Key_Backspace);
  EXPECT_FALSE(session_->attempt());
  EXPECT_TRUE(child<QWidget>("attemptsWords")->isVisible());
}

TEST_F(ReviewWindow, PlaysToTheEndAndStops) {
  openAll(recorded(home_.filePath("two")));
  session_->setSpeed(4);
  session_->setTime(8'000'000);
  QTest::mouseClick(child<QPushButton>("play"), Qt::LeftButton);
  EXPECT_TRUE(session_->isPlaying());
  EXPECT_EQ(child<QPushButton>("play")->text(), "Stop");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !session_->isPlaying(); }, kPatience_ms));
  EXPECT_EQ(session_->time_us(), session_->attempt()->end_us);
  key(Qt::Key_Space);
  EXPECT_TRUE(session_->isPlaying()) << "again from the begin";
  EXPECT_LT(time_s(), 5);
  key(Qt::Key_Space);
  EXPECT_FALSE(session_->isPlaying());
}

/// However many times come in a row, images are made of few of them, and the last is what stays.
TEST_F(ReviewWindow, ScrubbingLeavesPicturesBehindAndEndsWithTheLatest) {
  openAll(recorded(home_.filePath("two")));
  const int unpacked = session_->reader()->unpacked(), made = session_->picture().made();
  for (int i = 0; i <= 400; ++i) session_->setTime(std::int64_t(i) * 20'000);
  EXPECT_LE(session_->reader()->unpacked() - unpacked, 12) << "each stretch once";
  EXPECT_LE(session_->picture().made() - made, 1) << "no picture for a time that one is past already";
  settle();
  EXPECT_LE(session_->picture().made() - made, 2);
  EXPECT_EQ(session_->time_us(), 8'000'000);
  ASSERT_TRUE(session_->picture().shown()->needle);
  EXPECT_EQ(session_->picture().shown()->needle->tip_mm, session_->sample()->patientFromNeedle->offset);
}

TEST_F(ReviewWindow, AMomentIsGoneToByAClick) {
  openAll(recorded(home_.filePath("two")));
  auto* list = child<QListWidget>("moments");
  const int row = list->count() - 1;
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualItemRect(list->item(row)).center());
  EXPECT_EQ(session_->time_us(), session_->attempt()->moments[std::size_t(row)].time_us);
  session_->setTime(0);
  EXPECT_LT(list->currentRow(), row) << "the list follows the time";
  EXPECT_TRUE(child<QWidget>("resultPage")->isVisible()) << "an attempt opens with its result";
  list->setCurrentRow(row);
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_TRUE(child<QWidget>("replayPicture")->isVisible()) << "Enter shows the moment's picture";
  EXPECT_EQ(session_->time_us(), session_->attempt()->moments[std::size_t(row)].time_us);
}

TEST_F(ReviewWindow, TheScaleIsAtTheEdgeOfTheFieldOfView) {
  openAll(recorded(home_.filePath("two")));
  settle();
  const LiveFrame& frame = *session_->picture().shown();
  const BeamGrid field(frame.setup->probe, frame.setup->settings);
  ASSERT_LT(frame.image.left_mm, field.minLateral_mm() - 0.5) << "else the test shows nothing";
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("replayPicture")->view());
  const auto isShown = [&](double lateral_mm) { return view.isOnImage(view.displayFromImage({lateral_mm, 10})); };
  EXPECT_TRUE(isShown(field.minLateral_mm() + 0.2) && isShown(field.maxLateral_mm() - 0.2));
  EXPECT_FALSE(isShown(field.minLateral_mm() - 0.2) || isShown(field.maxLateral_mm() + 0.2));
}

TEST_F(ReviewWindow, TheResultHasTheRecordingsNumbers) {
  openAll(recorded(home_.filePath("two")));
  QTest::mouseClick(child<QToolButton>("resultTab"), Qt::LeftButton);
  const AttemptScore& score = *session_->attempt()->score;
  EXPECT_EQ(child<QLabel>("points")->text(), QString::number(std::lround(score.points.value())));
  EXPECT_EQ(child<QLabel>("advice")->text().toStdString(), score.advice);
  auto* table = child<QTableWidget>("metrics");
  EXPECT_EQ(table->rowCount(),
            std::ranges::count_if(metricTable(), [](const MetricDefinition& one) { return !isOfLine(one.metric); }))
      << "an attempt without a line has no metrics of a line";
  const auto value = [&](const char* name) {
    const auto found = table->findItems(name, Qt::MatchExactly);
    return found.isEmpty() ? QString() : table->item(found.first()->row(), 1)->text();
  };
  EXPECT_EQ(value("vein punctures"), "2");
  EXPECT_EQ(value("posterior wall punctures"), "1");
  EXPECT_EQ(value("attempt time"), "9.1 s");
  EXPECT_EQ(value("minimum distance to lung"), "n/a") << "the block has none";
  EXPECT_TRUE(table->item(0, 0)->toolTip().contains("Definition"));
  EXPECT_TRUE(child<QWidget>("pathPane")->isVisible());
}

TEST_F(ReviewWindow, TheResultIsWrittenAsPdfAndPicture) {
  openAll(recorded(home_.filePath("two")));
  QSignalSpy written(workspace_.get(), &ui::Workspace::written), failed(workspace_.get(), &ui::Workspace::failed);
  const QString pdf = home_.filePath("result.pdf"), png = home_.filePath("result.png");
  workspace_->saveResult(pdf);
  workspace_->saveResult(png);
  EXPECT_EQ(written.size(), 2);
  QFile file(pdf);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  EXPECT_TRUE(file.readAll().startsWith("%PDF"));
  const QImage page(png);
  EXPECT_NEAR(double(page.height()) / page.width(), 297.0 / 210, 0.01);
  EXPECT_EQ(page.pixelColor(2, 2), QColor(Qt::white));
  workspace_->saveResult(home_.filePath("no/such/folder.pdf"));
  ASSERT_EQ(failed.size(), 1);
  EXPECT_TRUE(failed[0][0].toString().contains("could not be written"));
}

TEST_F(ReviewWindow, TheCaseIsAskedForWhereItIsKnown) {
  QSettings().clear();
  QSignalSpy wanted(workspace_.get(), &ui::Workspace::caseRequested), failed(workspace_.get(), &ui::Workspace::failed);
  const QString file = recorded(home_.filePath("two"));
  open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.size() == 1; }, kPatience_ms));
  EXPECT_TRUE(failed[0][0].toString().contains("'Small block'"));
  EXPECT_EQ(wanted.size(), 0);
  EXPECT_TRUE(workspace_->statusText().contains("Open that case")) << workspace_->statusText().toStdString();
  EXPECT_GT(child<QListWidget>("moments")->count(), 0) << "what needs no case is there";

  QDir(home_.path()).mkdir("block");
  ui::rememberCase({home_.filePath("block"), "Small block"});
  open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return wanted.size() == 1; }, kPatience_ms));
  EXPECT_EQ(wanted[0][0].toString(), home_.filePath("block"));
  workspace_->setCase(block());
  settle();
  EXPECT_EQ(session_->fit(), CaseFit::Same);
}

TEST_F(ReviewWindow, ACaseThatHasChangedIsSaid) {
  auto other = std::make_shared<PatientCase>(*block());
  other->ct.voxels.front() += 1;
  workspace_->setCase(other);
  open(recorded(home_.filePath("two")));
  settle();
  EXPECT_EQ(session_->fit(), CaseFit::Changed);
  EXPECT_TRUE(child<QLabel>("attemptNotice")->isVisible());
  EXPECT_TRUE(child<QLabel>("attemptNotice")->text().contains("has changed"));
  EXPECT_FALSE(session_->picture().shown()) << "pictures of another case would be no replay";
  EXPECT_TRUE(session_->sample());
  other = std::make_shared<PatientCase>(*block());
  other->manifest.title = "Another";
  workspace_->setCase(other);
  EXPECT_EQ(session_->fit(), CaseFit::Other);
  EXPECT_FALSE(session_->picture().shown());
  EXPECT_TRUE(child<QLabel>("attemptNotice")->text().contains("not on the open case"));
}

TEST_F(ReviewWindow, TheVersionThatAnAttemptWasMadeOnIsAskedForByItself) {
  const auto folder = std::filesystem::path(home_.filePath("block").toStdString());
  ASSERT_TRUE(saveCaseVersion(*block(), folder, "2026-11-22", ""));
  auto later = std::make_shared<PatientCase>(*block());
  later->labels.voxels.front() = kBone;
  ASSERT_TRUE(saveCaseVersion(*later, folder, "2026-11-23", ""));
  ui::rememberCase({home_.filePath("block"), "Small block"});
  QSignalSpy wanted(workspace_.get(), &ui::Workspace::caseRequested);
  const std::string kept = (folder / "versions" / "001").string();
  // Over the case as it is now.
  workspace_->setCase(later);
  const QString file = recorded(home_.filePath("two"));
  open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return wanted.size() == 1; }, kPatience_ms));
  EXPECT_EQ(wanted[0][0].toString().toStdString(), kept);
  EXPECT_TRUE(child<QLabel>("attemptNotice")->text().contains("is still stored")) << "for who stays with the case";
  settle();
  EXPECT_EQ(wanted.size(), 1) << "asked once";
  workspace_->setCase(block());
  settle();
  EXPECT_EQ(session_->fit(), CaseFit::Same);
  // Over another case.
  auto other = std::make_shared<PatientCase>(*block());
  other->manifest.title = "Another";
  workspace_->setCase(other);
  open(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return wanted.size() == 2; }, kPatience_ms));
  EXPECT_EQ(wanted[1][0].toString().toStdString(), kept);
}

TEST_F(ReviewWindow, WhatIsMissingIsSaidAndARefusedFileLeavesWhatWasOpen) {
  const QString cut = recorded(home_.filePath("cut"));
  ASSERT_TRUE(QFile(cut).resize(QFile(cut).size() * 7 / 10));
  openAll(cut);
  EXPECT_TRUE(child<QLabel>("attemptNotice")->text().contains("stopped early, so the attempt counts as abandoned"));
  EXPECT_TRUE(child<QLabel>("attemptFacts")->text().contains("abandoned: the recording stopped early"));
  QFile garbage(home_.filePath("garbage.attempt"));
  ASSERT_TRUE(garbage.open(QIODevice::WriteOnly));
  garbage.write("words");
  garbage.close();
  QSignalSpy failed(workspace_.get(), &ui::Workspace::failed);
  workspace_->openAttempt(garbage.fileName());
  ASSERT_TRUE(QTest::qWaitFor([&] { return failed.size() == 1; }, kPatience_ms));
  EXPECT_TRUE(failed[0][0].toString().contains("is not a recording"));
  EXPECT_EQ(session_->attempt()->file, cut.toStdString());
}

TEST_F(ReviewWindow, RecordingsOfOthersAreNotListed) {
  QDir().mkpath(ui::attemptsFolder());
  const auto fileOf = [](const char* name) {
    return QDir(ui::attemptsFolder()).filePath(QLatin1String(name) + ui::kAttemptSuffix);
  };
  recorded(fileOf("free"));
  AttemptHeader header = AttemptRecording::open(fileOf("free").toStdString())->header();
  header.recordedFor.person = "anna";
  auto annas = AttemptRecorder::start(fileOf("annas").toStdString(), header);
  ASSERT_TRUE(annas && (*annas)->finish(AttemptStatus::Completed));
  workspace_->hide();
  workspace_->show();
  auto* table = child<QTableWidget>("attempts");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->rowCount() == 1; }, kPatience_ms)) << "a guest sees no one's";
  auto* list = workspace_->findChild<AttemptList*>();
  list->setUser("ben", false);
  EXPECT_EQ(table->rowCount(), 1);
  list->setUser("anna", false);
  EXPECT_EQ(table->rowCount(), 2);
  list->setUser("ina", true);
  EXPECT_EQ(table->rowCount(), 2) << "who teaches sees all";
  QFile::remove(fileOf("free"));
  list->setUser("ben", false);
  const auto saysSo = [&] {
    list->refresh();
    return child<QLabel>("attemptsWords")->text().contains("of people who have signed in: 1.");
  };
  EXPECT_TRUE(QTest::qWaitFor(saysSo, kPatience_ms)) << child<QLabel>("attemptsWords")->text().toStdString();
  for (const char* name : {"free", "annas"}) QFile::remove(fileOf(name));
}

TEST_F(ReviewWindow, TheUsersAttemptsAreListedAndOpened) {
  QDir().mkpath(ui::attemptsFolder());
  const QString file = QDir(ui::attemptsFolder()).filePath("mine" + ui::kAttemptSuffix);
  recorded(file);
  workspace_->hide();
  workspace_->show();
  auto* table = child<QTableWidget>("attempts");
  ASSERT_TRUE(QTest::qWaitFor([&] { return table->rowCount() == 1; }, kPatience_ms));
  EXPECT_EQ(table->item(0, 1)->text(), "Small block");
  EXPECT_EQ(table->item(0, 2)->text(), "Internal jugular vein with ultrasound");
  EXPECT_EQ(table->item(0, 3)->text(), "0:09.10");
  EXPECT_EQ(table->item(0, 4)->text(), "completed");
  QTest::keyClick(table, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return session_->attempt() != nullptr; }, kPatience_ms));
  QTest::mouseClick(child<QPushButton>("backToList"), Qt::LeftButton);
  EXPECT_TRUE(table->isVisible());
  QFile::remove(file);
}

TEST_F(ReviewWindow, AHiddenRoomPlaysNothingAndMakesNoPictures) {
  openAll(recorded(home_.filePath("two")));
  key(Qt::Key_Space);
  EXPECT_TRUE(session_->isPlaying());
  workspace_->hide();
  EXPECT_FALSE(session_->isPlaying());
  EXPECT_FALSE(session_->picture().shown());
  workspace_->show();
  settle();
  EXPECT_TRUE(session_->picture().shown());
}

TEST_F(ReviewWindow, The3dIsOpenedByAPanelAndStaysOpenedWhileTheReplayGoesOn) {
  openAll(recorded(home_.filePath("one.attempt")));
  auto* scroll = child<QWidget>("scenePanel");
  EXPECT_FALSE(scroll->isVisible());
  key(Qt::Key_3);
  EXPECT_TRUE(scroll->isVisible());
  EXPECT_TRUE(child<QWidget>("eye6")->isVisible()) << "the vein is in the list";
  const auto picture = [&] { return child<ui::ViewWidget>("replayScene")->grab().toImage(); };
  // 3D is drawn by a thread of its own.
  const auto changes = [&](const QImage& from) {
    return QTest::qWaitFor([&] { return picture() != from; }, kPatience_ms);
  };
  settle();
  QTest::qWait(1000);
  const QImage whole = picture();
  auto* kind = child<QComboBox>("clippingKind");
  kind->setCurrentIndex(1);
  Q_EMIT kind->activated(1);
  EXPECT_TRUE(changes(whole)) << "clipped";
  QTest::qWait(1000);
  const QImage opened = picture();
  session_->setTime(session_->attempt()->end_us / 2);
  EXPECT_TRUE(changes(opened)) << "the hands are elsewhere";
  EXPECT_EQ(kind->currentIndex(), 1);
  key(Qt::Key_3);
  EXPECT_FALSE(scroll->isVisible());
}

TEST_F(ReviewWindow, EveryControlHasANameAndATip) {
  openAll(recorded(home_.filePath("two")));
  for (const auto* button : workspace_->findChildren<QAbstractButton*>())
    if (button->isVisible()) {
      EXPECT_FALSE(button->toolTip().isEmpty()) << button->objectName().toStdString();
      EXPECT_FALSE(button->text().isEmpty() && button->accessibleName().isEmpty())
          << button->objectName().toStdString();
    }
}

}  // namespace
}  // namespace insonate::review
