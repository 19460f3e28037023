#include "TrainWindow.h"

#include <insonate/tissue/Labels.h>
#include <insonate/train/TrainBenchmark.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/views/SceneView.h>

#include <QCheckBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QWheelEvent>
#include <optional>

namespace insonate::train {
namespace {

/// Contents of 3D, and the panel that describes them.
class TrainScene : public TrainWindow {
 protected:
  ui::ViewWidget* sceneWidget() { return child<ui::ViewWidget>("sceneView"); }
  views::SceneView& scene() { return static_cast<views::SceneView&>(sceneWidget()->view()); }
  ui::ScenePanel* panel() { return child<ui::ScenePanel>("scenePanel"); }
  ui::ViewWidget* slice() {
    for (auto* one : workspace_->findChildren<ui::ViewWidget*>())
      if (one->accessibleName() == "CT slice") return one;
    return nullptr;
  }
};

TEST_F(TrainScene, ThePanelStandsInThePlaceOfTheSlice) {
  openCase();
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(slice()->isVisible());
  child<QToolButton>("sceneTab")->click();
  EXPECT_TRUE(panel()->isVisible());
  EXPECT_FALSE(slice()->isVisible());
  EXPECT_TRUE(sceneWidget()->isVisible()) << "what is changed is seen";
  ASSERT_TRUE(QTest::qWaitFor([&] { return panel()->findChild<QToolButton*>("eye6") != nullptr; }, kPatience_ms));
  panel()->findChild<QToolButton*>("eye6")->click();
  EXPECT_FALSE(scene().isVisible(kVein));
  for (auto* tab : workspace_->findChildren<QToolButton*>())
    if (tab->accessibleName() == "Axial slice") tab->click();
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(slice()->isVisible());
}

TEST_F(TrainScene, SpeedIsMeasuredFromWhenPicturesCome) {
  openCase();
  std::optional<LiveRates> rates;
  workspace_->benchmark().measureLive(0.01, false, [&](const LiveRates& measured) { rates = measured; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return rates.has_value(); }, kPatience_ms));
  EXPECT_LT(rates->seconds, 5) << "the time before is not counted";
  workspace_->benchmark().measureLive(2, false, [&](const LiveRates& measured) { rates = measured; });
  rates.reset();
  ASSERT_TRUE(QTest::qWaitFor([&] { return rates.has_value(); }, kPatience_ms));
  EXPECT_GT(rates->images, 0);
  EXPECT_NEAR(rates->imagesPerSecond, rates->images / rates->seconds, 1e-9);
}

TEST_F(TrainScene, ClippingAlongTheImagePlaneGoesWithTheProbe) {
  openCase();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !scene().structures().empty(); }, kPatience_ms));
  scene().setClipping({views::ClippingKind::ImagePlane});
  ASSERT_TRUE(QTest::qWaitFor([&] { return scene().clippingPlane().has_value(); }, kPatience_ms));
  const Vec3 before = scene().clippingPlane()->point_mm;
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return norm(scene().clippingPlane()->point_mm - before) > 0.5; }, kPatience_ms));
}

TEST_F(TrainScene, TheWheelDrawsCoarserUntilItRests) {
  openCase();
  QWidget* canvas = sceneWidget()->focusProxy();
  QWheelEvent event({20, 20}, canvas->mapToGlobal(QPoint(20, 20)), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(canvas, &event);
  EXPECT_TRUE(scene().isMoving());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !scene().isMoving(); }, kPatience_ms));
}

TEST_F(TrainScene, StructuresLookAsTheirAuthorChose) {
  PatientCase authored = test::smallCase();
  authored.colors = {{kVein, {10, 220, 40}}};
  authored.manifest.shown = {{kVein, {0.4, true}}, {kBone, {1, false}}, {kSoftTissue, {0.5, true}}};
  workspace_->setCase(std::make_shared<const PatientCase>(authored));
  EXPECT_EQ(scene().color(kVein), (views::Color{10, 220, 40}));
  EXPECT_NEAR(scene().opacity(kVein), 0.4, 1e-9);
  EXPECT_FALSE(scene().isVisible(kBone));
  const auto made = [&] { return scene().structures(); };
  EXPECT_TRUE(QTest::qWaitFor([&] { return std::ranges::count(made(), kSoftTissue) == 1; }, kPatience_ms))
      << "what the author shows has its surface";
  workspace_->setCase(patient());
  EXPECT_EQ(scene().color(kVein), views::labelColor(kVein, views::ColorScheme::Default));
  EXPECT_TRUE(scene().isVisible(kBone));
}

TEST_F(TrainScene, LooksAreRememberedAndTheSliceHasTheirColors) {
  panel()->setColorScheme(views::ColorScheme::ColorBlindSafe);
  scene().setVisible(kBone, false);
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("layout.ini"), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  auto& again = static_cast<views::SceneView&>(other.findChild<ui::ViewWidget*>("sceneView")->view());
  EXPECT_FALSE(again.isVisible(kBone));
  EXPECT_EQ(again.color(kVein), views::labelColor(kVein, views::ColorScheme::ColorBlindSafe));
}

}  // namespace
}  // namespace insonate::train
