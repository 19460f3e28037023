#include "TrainWindow.h"
#include "image/ScaledPicture.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/UltrasoundView.h>

#include <QLabel>

namespace insonate::train {
namespace {

TEST_F(TrainWindow, FirstPictureArrives) {
  EXPECT_FALSE(workspace_->isReady());
  openCase();
  ASSERT_TRUE(model_->live.shown());
  EXPECT_EQ(model_->live.shown()->image.width, 128);
  EXPECT_GT(std::ranges::max(model_->live.shown()->image.gray), 40) << "something is seen";
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->engineText().contains("up to date"); }, kPatience_ms));
  ASSERT_TRUE(QTest::qWaitFor(
      [&] {
        key(Qt::Key_Right);
        key(Qt::Key_Left);
        return workspace_->engineText().contains("fps");
      },
      kPatience_ms));
}

TEST_F(TrainWindow, SettingsReachThePicture) {
  openCase();
  child<ui::ValueSlider>("depth")->setValue(30);
  settle();
  EXPECT_EQ(model_->live.shown()->setup->settings.depth_mm, 30);
}

TEST_F(TrainWindow, FocusStaysWithinTheDepth) {
  child<ui::ValueSlider>("depth")->setValue(60);
  child<ui::ValueSlider>("focus")->setValue(55);
  child<ui::ValueSlider>("depth")->setValue(25);
  EXPECT_EQ(model_->imaging.settings().focus_mm, 25);
  EXPECT_EQ(child<ui::ValueSlider>("focus")->value(), 25);
}

TEST_F(TrainWindow, ProbeBringsItsDepthAndKeepsTheGain) {
  child<ui::ValueSlider>("gain")->setValue(5);
  ASSERT_TRUE(model_->imaging.setProbe("curvilinear"));
  EXPECT_EQ(model_->imaging.settings().depth_mm, 120);
  EXPECT_EQ(model_->imaging.settings().gain_dB, 5);
  EXPECT_EQ(child<ui::ValueSlider>("depth")->range().maximum, 300);
  EXPECT_EQ(child<QComboBox>("probe")->currentText(), "curvilinear");
  EXPECT_FALSE(model_->imaging.setProbe("no such probe"));
}

TEST_F(TrainWindow, KeysMoveTheProbe) {
  openCase();
  const Vec3 start = model_->motion.numbers().skin_mm;
  key(Qt::Key_Right);
  EXPECT_NEAR(model_->motion.numbers().skin_mm.x - start.x, 1, 0.1);
  key(Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(model_->motion.numbers().skin_mm.x - start.x, -4, 0.2);
  key(Qt::Key_W);
  EXPECT_NEAR(model_->motion.numbers().tilt_deg, 1, 1e-6);
  key(Qt::Key_D, Qt::ShiftModifier);
  EXPECT_NEAR(model_->motion.numbers().rock_deg, 5, 1e-6);
  key(Qt::Key_E);
  EXPECT_NEAR(model_->motion.numbers().rotation_deg, 2, 0.5);
  const double press_mm = model_->motion.numbers().press_mm;
  key(Qt::Key_Plus);
  EXPECT_NEAR(model_->motion.numbers().press_mm, press_mm + 0.5, 1e-6);
  settle();
  EXPECT_EQ(model_->live.shown()->patientFromProbe, model_->motion.pose());
}

/// The former image stays for a moment, and never as that of the new position.
TEST_F(TrainWindow, AfterAJumpTheFormerImageIsMarkedAtOnce) {
  openCase();
  settle();
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("ultrasoundView")->view());
  const auto saysLive = [&] {
    return std::ranges::any_of(workspace_->findChildren<QLabel*>(),
                               [](const QLabel* label) { return label->text() == "live" && !label->isHidden(); });
  };
  EXPECT_TRUE(saysLive());
  EXPECT_EQ(view.staleMark(), "");
  model_->motion.moveTo(model_->motion.numbers().skin_mm + Vec3{-20, 0, 0});
  EXPECT_EQ(view.staleMark(), "Image of the previous position");
  EXPECT_FALSE(saysLive());
  EXPECT_FALSE(workspace_->engineText().contains("up to date"));
  model_->live.setFrozen(true);
  EXPECT_FALSE(model_->live.isFrozen()) << "it would be the image of another position";
  ASSERT_TRUE(
      QTest::qWaitFor([&] { return model_->live.shown()->patientFromProbe == model_->motion.pose(); }, kPatience_ms));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !model_->live.isStale(); }, kPatience_ms));
  EXPECT_EQ(view.staleMark(), "");
  EXPECT_TRUE(saysLive());
  settle();
  key(Qt::Key_Right);
  EXPECT_EQ(view.staleMark(), "") << "an image follows a moving hand";
}

TEST_F(TrainWindow, UndoAndHomeRestoreThePose) {
  openCase();
  const ProbePlacementState start = model_->motion.state();
  key(Qt::Key_Right);
  key(Qt::Key_W);
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(model_->motion.state(), start);
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_Home);
  EXPECT_LT(norm(model_->motion.pose().offset - model_->patientCase.start().position_mm), 1e-6);
}

TEST_F(TrainWindow, UndoAndRedoGoThroughMovesAndSettingsInOrder) {
  openCase();
  const ProbePlacementState start = model_->motion.state();
  const double depth_mm = model_->imaging.settings().depth_mm;
  key(Qt::Key_Right, Qt::ShiftModifier);
  const ProbePlacementState moved = model_->motion.state();
  child<ui::ValueSlider>("depth")->setValue(30);
  key(Qt::Key_Z);
  EXPECT_EQ(model_->imaging.settings().depth_mm, depth_mm);
  EXPECT_EQ(child<ui::ValueSlider>("depth")->value(), depth_mm);
  EXPECT_EQ(workspace_->statusText(), "Undone: change of an image setting.");
  EXPECT_EQ(model_->motion.state(), moved);
  key(Qt::Key_Z);
  EXPECT_EQ(model_->motion.state(), start);
  key(Qt::Key_Y);
  key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(model_->motion.state(), moved);
  EXPECT_EQ(model_->imaging.settings().depth_mm, 30);
  settle();
  ASSERT_TRUE(model_->imaging.setProbe("phased"));
  key(Qt::Key_Z);
  EXPECT_EQ(model_->imaging.probe().name, "linear");
  EXPECT_EQ(model_->imaging.settings().depth_mm, 30);
}

TEST_F(TrainWindow, AFrozenProbeIsNotMovedByUndo) {
  openCase();
  key(Qt::Key_Right);
  const ProbePlacementState moved = model_->motion.state();
  settle();
  key(Qt::Key_Space);
  key(Qt::Key_Z);
  EXPECT_EQ(model_->motion.state(), moved);
  EXPECT_TRUE(workspace_->statusText().contains("frozen"));
}

TEST_F(TrainWindow, MouseOnThePictureMovesTheProbe) {
  openCase();
  const QPoint middle = canvas_->rect().center();
  const ProbePlacementState start = model_->motion.state();
  drag(Qt::LeftButton, middle, middle + QPoint(40, 0));
  EXPECT_GT(model_->motion.state().skin_mm.x, start.skin_mm.x + 0.5);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(model_->motion.state(), start) << "a drag is undone as a whole";
  drag(Qt::RightButton, middle, middle + QPoint(40, 0));
  EXPECT_NEAR(model_->motion.numbers().rotation_deg, 10, 1);
}

TEST_F(TrainWindow, PositionsAreSavedAndRecalled) {
  openCase();
  auto* list = child<QListWidget>("positions");
  EXPECT_EQ(list->count(), 1);
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_W);
  const Transform saved = model_->motion.pose();
  child<QPushButton>("savePosition")->click();
  EXPECT_EQ(list->count(), 2);
  key(Qt::Key_1);
  EXPECT_LT(norm(model_->motion.pose().offset - model_->patientCase.start().position_mm), 1e-6);
  key(Qt::Key_2);
  EXPECT_LT(norm(model_->motion.pose().offset - saved.offset), 1e-6);

  test::TemporaryFolder folder;
  const QString file = QString::fromStdString((folder / "layout.ini").string());
  {
    QSettings settings(file, QSettings::IniFormat);
    workspace_->saveLayout(settings);
  }
  TrainWorkspace other;
  QSettings settings(file, QSettings::IniFormat);
  other.restoreLayout(settings);
  other.setCase(patient());
  EXPECT_EQ(other.findChild<QListWidget*>("positions")->count(), 2);
}

TEST_F(TrainWindow, SettingsAreRemembered) {
  ASSERT_TRUE(model_->imaging.setProbe("phased"));
  child<ui::ValueSlider>("gain")->setValue(9);
  test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  const auto* model = other.findChild<TrainModel*>();
  EXPECT_EQ(model->imaging.probe().name, "phased");
  EXPECT_EQ(model->imaging.settings().gain_dB, 9);
}

TEST_F(TrainWindow, FreezeHoldsThePicture) {
  openCase();
  key(Qt::Key_Right);
  settle();
  key(Qt::Key_Space);
  ASSERT_TRUE(model_->live.isFrozen());
  EXPECT_TRUE(child<QPushButton>("freeze")->isChecked());
  const auto held = model_->live.shown();
  const ProbePlacementState state = model_->motion.state();
  key(Qt::Key_Right);
  child<ui::ValueSlider>("gain")->setValue(12);
  QTest::qWait(300);
  EXPECT_EQ(model_->live.shown(), held);
  EXPECT_EQ(model_->motion.state(), state) << "the probe is held, too";
  key(Qt::Key_F);
  EXPECT_TRUE(QTest::qWaitFor([&] { return model_->live.shown() != held; }, kPatience_ms));
  EXPECT_EQ(model_->live.shown()->setup->settings.gain_dB, 12);
}

TEST_F(TrainWindow, CineStepsThroughTheLastPictures) {
  openCase();
  for (int i = 0; i < 3; ++i) {
    key(Qt::Key_Right);
    settle();
  }
  key(Qt::Key_Space);
  ASSERT_GE(model_->live.cine().size(), 3u);
  const int last = model_->live.cineIndex();
  EXPECT_EQ(last, int(model_->live.cine().size()) - 1);
  key(Qt::Key_Comma);
  EXPECT_EQ(model_->live.cineIndex(), last - 1);
  EXPECT_EQ(model_->live.shown(), model_->live.cine()[last - 1]);
  EXPECT_EQ(child<QSlider>("cine")->value(), last - 1);
  key(Qt::Key_Period);
  key(Qt::Key_Period);
  EXPECT_EQ(model_->live.cineIndex(), last) << "the end is the end";
  child<QSlider>("cine")->setValue(0);
  EXPECT_EQ(model_->live.shown(), model_->live.cine().front());
}

TEST_F(TrainWindow, PictureAndClipAreWritten) {
  test::TemporaryFolder folder;
  QString written, place, failed;
  QObject::connect(workspace_.get(), &ui::Workspace::written,
                   [&](const QString& what, const QString& where) { written = what, place = where; });
  QObject::connect(workspace_.get(), &ui::Workspace::failed, [&](const QString& what) { failed = what; });
  workspace_->saveImage(folder / "none.png");
  EXPECT_EQ(workspace_->statusText(), "There is no image yet.");
  openCase();
  workspace_->saveImage(folder / "picture.png");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !written.isEmpty(); }, kPatience_ms));
  EXPECT_EQ(written, "Image saved as picture.png.");
  EXPECT_EQ(place, QString::fromStdString(folder.path().string()));
  const QImage picture(QString::fromStdString((folder / "picture.png").string()));
  const BModeImage& image = model_->live.shown()->image;
  const QPoint origin = pictureOrigin(image);
  ASSERT_GE(picture.width(), origin.x() + image.width);
  for (const QPoint at : {QPoint(3, 5), QPoint(100, 40), QPoint(127, 95)})
    EXPECT_EQ(qGray(picture.pixel(origin + at)), image.gray[std::size_t(at.y()) * image.width + at.x()]);
  const BeamGrid field(model_->imaging.probe(), model_->imaging.settings());
  const int scale_px = origin.x() + int(std::lround((field.minLateral_mm() - image.left_mm) / image.pixel_mm));
  int ticks = 0;
  for (int y = origin.y() - 2; y < picture.height(); ++y) ticks += qGray(picture.pixel(scale_px - 6, y)) > 60;
  EXPECT_GE(ticks, int(model_->imaging.settings().depth_mm / 10)) << "a mark every centimetre at least";
  EXPECT_NEAR(1000.0 / picture.dotsPerMeterX(), model_->live.shown()->image.pixel_mm, 1e-3);
  workspace_->saveImage(folder / "no" / "such" / "folder.png");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, kPatience_ms));
  EXPECT_TRUE(failed.contains("does not exist")) << failed.toStdString();

  workspace_->saveClip(folder / "clip");
  ASSERT_TRUE(QTest::qWaitFor([&] { return written.startsWith("Clip"); }, kPatience_ms));
  EXPECT_EQ(place, QString::fromStdString((folder / "clip").string()));
  EXPECT_TRUE(std::filesystem::exists(folder / "clip" / "picture-0001.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "clip.part"));
  failed.clear();
  workspace_->saveClip(folder / "clip");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !failed.isEmpty(); }, kPatience_ms));
  EXPECT_TRUE(failed.contains("already")) << "what is there is not written over";
}

TEST_F(TrainWindow, OneEffectCanBeSeenAlone) {
  openCase();
  auto* effects = child<QComboBox>("effect");
  ASSERT_GT(effects->count(), 3);
  model_->imaging.setEffect(effects->itemData(1).toString().toStdString());
  const auto whole = model_->live.shown();
  EXPECT_TRUE(QTest::qWaitFor([&] { return model_->live.shown() != whole; }, kPatience_ms));
  model_->imaging.setEffect(ImagingModel::kWholeModel);
  EXPECT_EQ(effects->currentIndex(), 0);
}

/// A case that the scan cuts in front of its target, so that no start is found by itself.
std::shared_ptr<const PatientCase> cutCase() {
  PatientCase patient = test::smallCase();
  patient.manifest.startPoses.clear();
  patient.manifest.targets.clear();
  for (auto& label : patient.labels.voxels)
    if (label == kVein) label = kSoftTissue;
  const auto& size = patient.labels.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i) {
        // Skin on the patient's left only; the front is beyond the scan.
        const bool body = i < 30;
        patient.labels.at(i, j, k) = !body ? kBackground : i >= 28 ? kSkin : kSoftTissue;
        patient.ct.at(i, j, k) = body ? 30 : -1000;
      }
  return std::make_shared<const PatientCase>(std::move(patient));
}

TEST_F(TrainWindow, AProbeWithoutAStartIsPlacedByTheUser) {
  QStringList failures;
  QObject::connect(workspace_.get(), &ui::Workspace::failed, [&](const QString& what) { failures << what; });
  workspace_->setCase(cutCase());
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_->motion.isUnplaced(); }, kPatience_ms));
  EXPECT_TRUE(failures.isEmpty()) << failures.join(' ').toStdString();
  EXPECT_TRUE(child<QWidget>("placeOffer")->isVisible());
  EXPECT_FALSE(child<QWidget>("ultrasoundView")->isVisible());
  EXPECT_TRUE(workspace_->isReady()) << "nothing comes by itself";
  child<QPushButton>("placeOnSkin")->click();
  EXPECT_FALSE(child<QWidget>("placeOffer")->isVisible());
  EXPECT_TRUE(model_->motion.isReady());
  EXPECT_NEAR(model_->motion.state().skin_mm.x, 5.5, 1.5);
  EXPECT_NEAR(model_->motion.state().tilt_deg, 0, 1e-6) << "square to the skin";
  EXPECT_NEAR(model_->motion.state().rock_deg, 0, 1e-6);
  ASSERT_TRUE(QTest::qWaitFor([&] { return model_->live.shown() && workspace_->isReady(); }, kPatience_ms));
  workspace_->setCase(patient());
  EXPECT_FALSE(child<QWidget>("placeOffer")->isVisible());
  EXPECT_FALSE(model_->motion.isUnplaced());
}

TEST_F(TrainWindow, WhatACaseLacksIsToldOnceTrainIsSeen) {
  QStringList failures;
  QObject::connect(workspace_.get(), &ui::Workspace::failed, [&](const QString& what) { failures << what; });
  workspace_->hide();
  auto bare = std::make_shared<PatientCase>(test::smallCase());
  std::ranges::fill(bare->labels.voxels, kBackground);
  workspace_->setCase(bare);
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().contains("no skin"); }, kPatience_ms));
  EXPECT_TRUE(failures.isEmpty()) << failures.join(' ').toStdString();
  workspace_->show();
  ASSERT_EQ(failures.size(), 1);
  EXPECT_TRUE(failures.front().contains("no skin")) << failures.front().toStdString();
  workspace_->hide();
  workspace_->show();
  EXPECT_EQ(failures.size(), 1) << "once is enough";
}

TEST_F(TrainWindow, SaysThatACaseHasNoVessels) {
  openCase();
  auto* note = child<QLabel>("vesselNote");
  EXPECT_FALSE(note->isVisible());
  workspace_->setCase(cutCase());
  EXPECT_TRUE(QTest::qWaitFor([&] { return note->isVisible(); }, kPatience_ms));
  EXPECT_TRUE(note->text().contains("Label the vessels in Prepare")) << note->text().toStdString();
  workspace_->setCase(patient());
  EXPECT_FALSE(note->isVisible());
}

TEST_F(TrainWindow, WhatHappenedIsSaidForSomeSeconds) {
  openCase();
  child<QPushButton>("savePosition")->click();
  EXPECT_TRUE(workspace_->statusText().startsWith("Position saved"));
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().startsWith("Drag on the image"); },
                              StatusLine::kMessage_ms + 3000));
  key(Qt::Key_Space);
  key(Qt::Key_Right);
  EXPECT_TRUE(workspace_->statusText().contains("live again")) << workspace_->statusText().toStdString();
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().startsWith("The image is frozen. Comma"); },
                              StatusLine::kMessage_ms + 3000));
}

TEST_F(TrainWindow, AnotherCaseReplacesEverything) {
  openCase();
  key(Qt::Key_Right);
  key(Qt::Key_Space);
  workspace_->setCase(nullptr);
  EXPECT_FALSE(workspace_->isReady());
  EXPECT_FALSE(model_->live.isFrozen());
  EXPECT_FALSE(model_->live.shown());
  EXPECT_EQ(child<QListWidget>("positions")->count(), 0);
  key(Qt::Key_Right);
  key(Qt::Key_Home);
  workspace_->setCase(patient());
  workspace_->setCase(patient());
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
}

TEST_F(TrainWindow, GoesAtAnyMoment) {
  // While nothing is there, at once after a case came, and while the first scene is being built.
  for (const int wait_ms : {0, 1, 30, 120}) {
    auto workspace = std::make_unique<TrainWorkspace>();
    workspace->show();
    workspace->setCase(patient());
    if (wait_ms > 0) QTest::qWait(wait_ms);
  }
  auto stopped = std::make_unique<TrainWorkspace>();
  stopped->setCase(patient());
  stopped->stop();
}

TEST_F(TrainWindow, ACaseWithoutABodySaysSo) {
  auto empty = std::make_shared<PatientCase>(*patient());
  std::ranges::fill(empty->labels.voxels, kBackground);
  workspace_->setCase(empty);
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText().contains('.'); }, kPatience_ms));
  QTest::qWait(200);
  EXPECT_FALSE(model_->motion.isReady());
}

}  // namespace
}  // namespace insonate::train
