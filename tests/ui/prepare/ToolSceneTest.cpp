#include "ToolsWindow.h"
#include "tools/Tool.h"

#include <cmath>

namespace insonate::prepare {
namespace {

/// Drawings over 3D and on the slices beside the labels themselves.
class ToolScene : public Tools {
 protected:
  void SetUp() override {
    Tools::SetUp();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !scene().structures().empty(); }, kPatience_ms));
  }
  void dragInScene(const std::vector<QPoint>& line) {
    QWidget* at = canvas("Scene");
    QTest::mousePress(at, Qt::LeftButton, {}, line.front());
    for (const QPoint& point : line) {
      QMouseEvent move(QEvent::MouseMove, point, Qt::NoButton, Qt::LeftButton, Qt::NoModifier);
      QApplication::sendEvent(at, &move);
    }
    QTest::mouseRelease(at, Qt::LeftButton, {}, line.back());
  }
  /// Around the vein's middle, seen in 3D, in the canvas's pixels.
  std::vector<QPoint> boxAroundVein() {
    const double ratio = canvas("Scene")->devicePixelRatioF();
    const auto at = scene().displayFromPatient({0, 12, 0});
    const QPoint middle(int(at.x / ratio), int(at.y / ratio));
    return {middle + QPoint(-31, -17), middle + QPoint(31, -17), middle + QPoint(31, 17), middle + QPoint(-31, 17)};
  }
  QColor pixel(Vec3 patient_mm, QPoint off = {}) {
    return canvas("Axial slice")->grab().toImage().pixelColor(pointOf(patient_mm) + off);
  }
  bool comes(const std::function<bool()>& what) { return QTest::qWaitFor(what, kPatience_ms); }
};

bool isOrange(const QColor& c) {
  return c.red() > 150 && c.blue() < 110 && c.red() > c.blue() + 80;
}

bool isGray(const QColor& c) {
  return std::abs(c.red() - c.green()) < 6 && std::abs(c.green() - c.blue()) < 6;
}

TEST_F(ToolScene, ALineDrawnOver3DTakesFromTheLabelWhatIsSeenInIt) {
  child<QAction>("tool-cut")->trigger();
  const std::vector<QPoint> box = boxAroundVein();
  dragInScene(box);
  ASSERT_TRUE(comes([&] { return shared_->labeling.preview().proposal() != nullptr; })) << "shown when it is drawn";
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  EXPECT_LT(count(kVein), std::size_t(std::ranges::count(patient()->labels.voxels, kVein)));
  EXPECT_EQ(count(kBone), std::size_t(std::ranges::count(patient()->labels.voxels, kBone))) << "of this label only";
  const double ratio = canvas("Scene")->devicePixelRatioF();
  const VolumeGeometry& grid = labels().geometry;
  std::size_t cut = 0;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        if (patient()->labels.at(i, j, k) != kVein) continue;
        const auto seen = scene().displayFromPatient(grid.patientFromIndex() * Vec3{double(i), double(j), double(k)});
        const double x = seen.x / ratio - 0.5, y = seen.y / ratio - 0.5;
        const double edge = std::min({x - box[0].x(), box[2].x() - x, y - box[0].y(), box[2].y() - y});
        if (std::abs(edge) < 1) continue;
        EXPECT_EQ(labels().at(i, j, k) == kVein, edge < 0) << i << " " << j << " " << k;
        cut += edge > 0;
      }
  EXPECT_GT(cut, 50u);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
}

TEST_F(ToolScene, ScissorsGoAsDeepAsTheyAreSet) {
  shared_->structures.select(kBone);
  for (const std::uint8_t before : {kSkin, kVein}) shared_->appearance.setVisible(before, false);
  child<QAction>("tool-cut")->trigger();
  child<ui::ValueSlider>("tool-depth")->setValue(5);
  const QSize size = canvas("Scene")->size();
  const int w = size.width() - 4, h = size.height() - 4;
  dragInScene({{w / 2, h / 2}, {w, 3}, {w, h}, {3, h}, {3, 3}, {w, 3}});
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  const auto before = std::size_t(std::ranges::count(patient()->labels.voxels, kBone));
  EXPECT_LT(count(kBone), before);
  EXPECT_GT(count(kBone), 0u) << "not through all of it";
}

TEST_F(ToolScene, WithoutScissorsADragTurns3D) {
  const auto before = scene().displayFromPatient({20, 0, 8});
  child<QAction>("tool-cut")->trigger();
  dragInScene(boxAroundVein());
  EXPECT_NEAR(scene().displayFromPatient({20, 0, 8}).x, before.x, 1e-6) << "the tool has the mouse";
  key(Qt::Key_Escape);
  key(Qt::Key_Escape);
  dragInScene({{100, 100}, {160, 120}});
  EXPECT_GT(std::abs(scene().displayFromPatient({20, 0, 8}).x - before.x), 1);
}

TEST_F(ToolScene, APreviewIsSeenIn3DAndShowsNothingThatMayNotBeWritten) {
  shared_->structures.add(kArtery);
  key(Qt::Key_5);
  child<QSpinBox>("tool-to")->setValue(1000);
  constexpr std::uint8_t kPreview = 255;
  const auto has3D = [&] { return std::ranges::count(scene().structures(), kPreview) > 0; };
  EXPECT_TRUE(comes(has3D));
  shared_->labeling.setLocked(kBone, true);
  const auto proposed = [&] {
    const auto& proposal = shared_->labeling.preview().proposal();
    return proposal ? int(std::ranges::count(proposal->labels.voxels, kArtery)) : -1;
  };
  EXPECT_TRUE(comes([&] { return proposed() == 0; })) << "only bone is so bright, and it is locked";
  EXPECT_TRUE(comes([&] { return !has3D(); }));
}

TEST_F(ToolScene, LabelsAreFilledOutlinedOrBothAndEachAsStrongAsRequested) {
  shared_->crosshair.moveTo({20, 30, 0});
  const Vec3 inVein{0, 14, 0};  // beside the mark of the target, at any zoom
  ASSERT_TRUE(comes([&] { return !isGray(pixel(inVein)); })) << "filled";
  auto* style = child<QComboBox>("labelStyle");
  const auto choose = [&](int row) {
    style->setCurrentIndex(row);
    Q_EMIT style->activated(row);
  };
  choose(style->findText("outline"));
  EXPECT_TRUE(comes([&] { return isGray(pixel(inVein)); }));
  EXPECT_FALSE(child<ui::ValueSlider>("labelOpacity")->isEnabled()) << "there is no fill";
  choose(style->findText("fill"));
  EXPECT_TRUE(comes([&] { return !isGray(pixel(inVein)); }));
  EXPECT_FALSE(child<ui::ValueSlider>("outlineWidth")->isEnabled());
  shared_->structures.select(kVein);
  child<ui::ValueSlider>("structureOnSlices")->setValue(0);
  EXPECT_TRUE(comes([&] { return isGray(pixel(inVein)); }));
  EXPECT_FALSE(isGray(pixel({0, 30, 0}))) << "of the vein only";
  shared_->openCase.undoStack().undo();
  EXPECT_TRUE(comes([&] { return !isGray(pixel(inVein)); }));
}

TEST_F(ToolScene, TargetsAreMarkedOnSlicesWhileLabeling) {
  shared_->crosshair.moveTo({20, 30, 0});
  const auto marked = [&] { return isOrange(pixel({0, 12, 0}, {6, 0})) || isOrange(pixel({0, 12, 0}, {5, 0})); };
  EXPECT_TRUE(comes(marked));
  child<QCheckBox>("placesShown")->click();
  EXPECT_TRUE(comes([&] { return !marked(); }));
  child<QCheckBox>("placesShown")->click();
  EXPECT_TRUE(comes(marked));
  shared_->crosshair.moveTo({20, 30, 7});
  EXPECT_TRUE(comes([&] { return !marked(); })) << "7 mm away";
}

}  // namespace
}  // namespace insonate::prepare
