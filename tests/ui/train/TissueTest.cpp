#include "TrainWindow.h"
#include "probe/HeldPress.h"
#include "tissue/AreaPlot.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/AreaWords.h>
#include <insonate/views/UltrasoundView.h>

#include <QAction>
#include <QCheckBox>
#include <QLabel>

namespace insonate::train {
namespace {

/// Tissue gives way under the probe: what is shown of it, and chosen.
class TrainTissue : public TrainWindow {
 protected:
  void press(double mm) {
    model_->motion.typed(HandAxis::Press, mm);
    settle();
  }
  const LiveDeformation& now() { return model_->live.shown()->press; }
  double veinShare() {
    return now().lumens.empty() ? -1 : now().lumens.front().area_mm2 / now().lumens.front().rest_mm2;
  }
  bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience_ms); }
  QString text(const char* label) { return child<QLabel>(label)->text(); }
  /// Number of the image's pixels that have a color.
  int colored() {
    const QImage image = child<ui::ViewWidget>("ultrasoundView")->grab().toImage();
    int count = 0;
    for (int y = image.height() / 4; y < image.height() * 3 / 4; ++y)
      for (int x = image.width() / 4; x < image.width() * 3 / 4; ++x) {
        const QColor c = image.pixelColor(x, y);
        count += std::max({c.red(), c.green(), c.blue()}) - std::min({c.red(), c.green(), c.blue()}) > 20;
      }
    return count;
  }
};

TEST_F(TrainTissue, PressingShowsForceAndAreasAndLettingGoNothing) {
  openCase();
  press(0);
  EXPECT_TRUE(waitFor([&] { return text("pressForce").isEmpty() && text("veinArea").isEmpty(); }));
  press(5);
  ASSERT_TRUE(waitFor([&] { return now().force_N > 0.1 && veinShare() < 0.9; }));
  EXPECT_TRUE(waitFor([&] { return text("pressForce") == QString("%1 N").arg(now().force_N, 0, 'f', 1); }))
      << text("pressForce").toStdString();
  workspace_->resize(1900, 700);
  EXPECT_TRUE(waitFor([&] {
    return text("veinArea") == QString("veins %1\u00a0mm² · %2\u00a0% of the area in the CT")
                                   .arg(now().lumens.front().area_mm2, 0, 'f', 0)
                                   .arg(100 * veinShare(), 0, 'f', 0);
  })) << text("veinArea").toStdString();
  EXPECT_TRUE(child<QLabel>("veinArea")->accessibleName().endsWith("percent of the area in the CT"));
  workspace_->resize(1100, 700);
  EXPECT_TRUE(waitFor([&] { return text("veinArea").contains("\u00a0% of CT"); })) << text("veinArea").toStdString();
  EXPECT_TRUE(text("arteryArea").isEmpty()) << "there is none";
  EXPECT_TRUE(child<QLabel>("pressForce")->accessibleName().endsWith("newtons"));
  press(0);
  EXPECT_TRUE(waitFor([&] { return text("pressForce").isEmpty() && text("veinArea").isEmpty(); }));
}

TEST(AreaWords, SayInPercentOfWhat) {
  const LumenArea wider{kVein, 84.6, 60};
  EXPECT_EQ(ui::areaOf(wider, ui::AreaForm::Full), "85\u00a0mm² · 141\u00a0% of the area in the CT");
  EXPECT_EQ(ui::areaOf(wider, ui::AreaForm::Short), "85\u00a0mm² · 141\u00a0% of CT area");
  EXPECT_EQ(ui::areaOf(wider, ui::AreaForm::Share), "141\u00a0% of CT");
  EXPECT_EQ(ui::spokenAreaOf(wider), "85 square millimeters, 141 percent of the area in the CT");
  EXPECT_EQ(ui::areaOf({kVein, 0, 60}, ui::AreaForm::Short), "0\u00a0mm² · 0\u00a0% of CT area") << "compressed";
  EXPECT_EQ(ui::areaOf({kVein, 0, 0}, ui::AreaForm::Full), "n/a") << "the CT shows none";
}

TEST_F(TrainTissue, PostureAndVenousPressureWidenTheVein) {
  openCase();
  press(3);
  ASSERT_TRUE(waitFor([&] { return now().force_N > 0 && now().settled; }));
  const double supine = veinShare();
  auto* posture = child<QComboBox>("posture");
  posture->setCurrentIndex(posture->findData(25.0));
  Q_EMIT posture->activated(posture->currentIndex());
  EXPECT_EQ(model_->imaging.tissue().body.tilt_deg, 25);
  EXPECT_TRUE(waitFor([&] { return veinShare() > supine + 0.03; })) << supine << " to " << veinShare();
  key(Qt::Key_Z);
  EXPECT_EQ(model_->imaging.tissue().body.tilt_deg, 0);
  EXPECT_EQ(posture->currentData().toDouble(), 0);
  EXPECT_TRUE(waitFor([&] { return std::abs(veinShare() - supine) < 0.02; })) << supine << " to " << veinShare();
  child<ui::ValueSlider>("centralVenous")->setValue(12);
  EXPECT_TRUE(waitFor([&] { return veinShare() > supine + 0.03; }));
}

TEST_F(TrainTissue, WithoutAModelNothingGivesWay) {
  openCase();
  auto* model = child<QComboBox>("tissueModel");
  model->setCurrentIndex(model->findData("none"));
  Q_EMIT model->activated(model->currentIndex());
  press(4);
  ASSERT_TRUE(waitFor([&] { return model_->live.shown()->setup->mechanics.model == "none"; }));
  EXPECT_EQ(now().force_N, 0);
  key(Qt::Key_Z);
  key(Qt::Key_Z);
  EXPECT_EQ(model_->imaging.tissue().model, "elastic");
}

TEST_F(TrainTissue, AHeartMovesTheVesselsWhileSomebodyLooks) {
  openCase();
  press(2);
  child<QCheckBox>("breathing")->click();
  ASSERT_TRUE(model_->imaging.tissue().breathing);
  const auto pictures = [&] { return model_->live.shown()->number; };
  const auto before = pictures();
  EXPECT_TRUE(waitFor([&] { return pictures() > before + 10; })) << "nobody moves the probe";
  const auto expectRest = [&](const char* where) {
    QTest::qWait(300);
    const auto hidden = pictures();
    QTest::qWait(500);
    EXPECT_LE(pictures(), hidden + 2) << where;
  };
  workspace_->hide();
  expectRest("another workspace");
  workspace_->show();
  const auto shownAgain = pictures();
  EXPECT_TRUE(waitFor([&] { return pictures() > shownAgain + 10; }));

  key(Qt::Key_J);
  expectRest("the levels in the picture's place");
  workspace_->hide();
  workspace_->show();
  expectRest("the levels are still there");
  key(Qt::Key_J);
  const auto back = pictures();
  EXPECT_TRUE(waitFor([&] { return pictures() > back + 10; }));
}

TEST_F(TrainTissue, GridAndPressureAreAskedForOnlyWhileTheyAreShown) {
  openCase();
  press(5);
  ASSERT_TRUE(waitFor([&] { return now().force_N > 0.1 && veinShare() < 0.9; }));
  EXPECT_TRUE(now().mesh.nodes.empty());
  EXPECT_LT(colored(), 50);
  key(Qt::Key_T);
  ASSERT_TRUE(waitFor([&] { return !now().mesh.nodes.empty(); })) << "although the probe is held still";
  EXPECT_TRUE(waitFor([&] { return colored() > 500; }));
  const int grid = colored();
  key(Qt::Key_P);
  EXPECT_TRUE(child<QAction>("train.tissue.pressure")->isChecked());
  EXPECT_TRUE(waitFor([&] { return colored() > 2 * grid; }));
  key(Qt::Key_P);
  EXPECT_FALSE(now().mesh.nodes.empty());
  child<QAction>("train.tissue.grid")->trigger();
  EXPECT_TRUE(waitFor([&] { return now().mesh.nodes.empty(); }));
  EXPECT_TRUE(waitFor([&] { return colored() < 50; }));
}

TEST_F(TrainTissue, TheCurveKeepsWhereTheAreasHaveBeenUntilItIsCleared) {
  openCase();
  auto* plot = child<AreaPlot>("areaPlot");
  EXPECT_FALSE(plot->isVisible());
  key(Qt::Key_K);
  EXPECT_TRUE(plot->isVisible());
  press(0);
  child<QPushButton>("clearCurve")->click();
  EXPECT_EQ(plot->points(), 0U);
  for (const double mm : {2.0, 4.0}) press(mm);
  EXPECT_TRUE(waitFor([&] { return plot->points() >= 2; }));
  EXPECT_TRUE(waitFor([&] { return plot->accessibleName().contains("CT, against force. Vein"); }));
  child<QPushButton>("clearCurve")->click();
  EXPECT_EQ(plot->points(), 0U);
  key(Qt::Key_K);
  EXPECT_FALSE(plot->isVisible());
}

TEST_F(TrainTissue, TheCurveLeavesOutWhatAModelOnItsWayExaggerates) {
  AreaPlot plot;
  LiveDeformation press;
  press.lumens = {{kVein, 60, 120}};
  press.force_N = 1;
  plot.add(press);
  EXPECT_EQ(plot.points(), 1U);
  press.force_N = 80, press.settled = false;
  plot.add(press);
  EXPECT_EQ(plot.points(), 1U);
  press.force_N = 3, press.settled = true;
  plot.add(press);
  EXPECT_EQ(plot.points(), 2U);
  press.force_N = 0;
  plot.add(press);
  EXPECT_EQ(plot.points(), 2U) << "nothing presses";
  for (std::size_t k = 0; k < 2 * AreaPlot::kMost; ++k) press.force_N = 1, plot.add(press);
  EXPECT_EQ(plot.points(), AreaPlot::kMost);
}

TEST_F(TrainTissue, HoldingTheKeyPressesSmoothlyUntilItComesUp) {
  openCase();
  const double before = model_->motion.numbers().press_mm;
  QTest::keyPress(canvas_, Qt::Key_Plus);
  EXPECT_NEAR(model_->motion.numbers().press_mm, before + 0.5, 1e-6);
  EXPECT_TRUE(waitFor([&] { return model_->motion.numbers().press_mm > before + 1; }));
  QTest::keyRelease(canvas_, Qt::Key_Plus);
  const double held = model_->motion.numbers().press_mm;
  QTest::qWait(HeldPress::kBegins_ms + 100);
  EXPECT_EQ(model_->motion.numbers().press_mm, held);
  key(Qt::Key_Z);
  EXPECT_NEAR(model_->motion.numbers().press_mm, before, 1e-6) << "one gesture";
}

TEST_F(TrainTissue, ArterialPressureThatCannotBeIsRefused) {
  auto* systolic = child<QLineEdit>("systolic");
  const auto type = [&](const char* words) {
    systolic->setFocus();
    systolic->selectAll();
    QTest::keyClicks(systolic, words);
    QTest::keyClick(systolic, Qt::Key_Return);
  };
  type("150");
  EXPECT_EQ(model_->imaging.tissue().body.systolic_mmHg, 150);
  type("60");
  EXPECT_EQ(model_->imaging.tissue().body.systolic_mmHg, 150) << "below the diastolic pressure";
  EXPECT_FALSE(workspace_->statusText().isEmpty());
}

TEST_F(TrainTissue, ChoicesAreRemembered) {
  openCase();
  TissueChoice choice = model_->imaging.tissue();
  choice.model = "column";
  choice.body.tilt_deg = 15, choice.body.centralVenous_mmHg = 7, choice.body.systolic_mmHg = 140;
  choice.breathing = true;
  model_->imaging.setTissue(choice);
  child<QAction>("train.tissue.areas")->trigger();
  QSettings settings;
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  EXPECT_EQ(other.findChild<TrainModel*>()->imaging.tissue(), choice);
  EXPECT_TRUE(other.findChild<QAction*>("train.tissue.areas")->isChecked());
  settings.setValue("tissue/model", "jelly");
  settings.setValue("tissue/systolic_mmHg", 10);
  other.restoreLayout(settings);
  EXPECT_EQ(other.findChild<TrainModel*>()->imaging.tissue().model, "elastic");
  EXPECT_EQ(other.findChild<TrainModel*>()->imaging.tissue().body.systolic_mmHg, 120);
}

TEST_F(TrainTissue, ClosesWhilePressing) {
  openCase();
  key(Qt::Key_T);
  key(Qt::Key_P);
  child<QCheckBox>("pulse")->click();
  QTest::keyPress(canvas_, Qt::Key_Plus);
  QTest::qWait(HeldPress::kBegins_ms + 150);
  workspace_ = nullptr;
  QTest::qWait(50);
}

}  // namespace
}  // namespace insonate::train
