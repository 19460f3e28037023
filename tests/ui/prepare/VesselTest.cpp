#include "ToolsWindow.h"
#include "vessel/VesselSession.h"

#include <gmock/gmock.h>

#include <QWheelEvent>
#include <cmath>

namespace insonate::prepare {
namespace {

using testing::HasSubstr;

/// The vessel view as a user has it: the key, the wheel, and the mouse on the sections.
class Vessel : public Tools {
 protected:
  void SetUp() override {
    Tools::SetUp();
    key(Qt::Key_V);
    session_ = workspace_->findChild<VesselSession*>();
    ASSERT_TRUE(session_);
    ASSERT_TRUE(QTest::qWaitFor([&] { return session_->course() != nullptr; }, kPatience_ms))
        << session_->reason().toStdString();
    QApplication::processEvents();
  }
  QWidget& sections() { return *child<QWidget>("vesselSections"); }
  /// Moves the mouse on the sections.
  void moveTo(QPoint at, Qt::MouseButtons held = Qt::NoButton) {
    QMouseEvent move(QEvent::MouseMove, at, Qt::NoButton, held, Qt::NoModifier);
    QApplication::sendEvent(&sections(), &move);
  }
  /// Finds the wall of the large section to the right of its middle, where the pointer becomes a hand.
  QPoint wall() {
    const QPoint middle(sections().width() / 2, (sections().height() - 18) / 2);
    int first = 0, last = 0;
    for (int x = 0; x < sections().width() / 2; ++x) {
      moveTo(middle + QPoint(x, 0));
      if (sections().cursor().shape() != Qt::PointingHandCursor) continue;
      if (first == 0) first = x;
      last = x;
    }
    return middle + QPoint((first + last) / 2, 0);
  }
  void dragWall(int by_px, int patience_ms = kPatience_ms) {
    const QPoint from = wall();
    QTest::mousePress(&sections(), Qt::LeftButton, {}, from);
    for (const int part : {1, 2}) moveTo(from + QPoint(by_px * part / 2, 0), Qt::LeftButton);
    wasPreviewed_ = QTest::qWaitFor([&] { return shared_->labeling.preview().proposal() != nullptr; }, patience_ms);
    QTest::mouseRelease(&sections(), Qt::LeftButton, {}, from + QPoint(by_px, 0));
    ASSERT_TRUE(done());
  }
  void wheel(int turned, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QWidget& view = *child<QWidget>("vesselPanel");
    const QPointF at(view.rect().center());
    QWheelEvent event(at, view.mapToGlobal(at.toPoint()), {}, {0, turned}, Qt::NoButton, modifiers, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(&view, &event);
  }

  VesselSession* session_ = nullptr;
  bool wasPreviewed_ = false;
};

TEST_F(Vessel, TheKeyShowsTheVesselInPlaceOfTheLowerViews) {
  EXPECT_TRUE(child<QWidget>("vesselPanel")->isVisible());
  EXPECT_FALSE(child<QWidget>("Scene")->isVisible());
  EXPECT_TRUE(child<QWidget>("Axial slice")->isVisible());
  EXPECT_NEAR(session_->course()->length_mm(), 16, 2);
  EXPECT_NEAR(session_->outline().radius_mm[0], 5, 0.6);
  key(Qt::Key_V);
  EXPECT_FALSE(child<QWidget>("vesselPanel")->isVisible());
  EXPECT_TRUE(child<QWidget>("Scene")->isVisible());
  EXPECT_FALSE(session_->course()) << "nothing is computed for a hidden view";
}

TEST_F(Vessel, WithoutAVesselASentenceSaysWhatToDo) {
  shared_->structures.select(kBone);
  EXPECT_TRUE(child<QLabel>("vesselReason")->isVisible());
  EXPECT_THAT(child<QLabel>("vesselReason")->text().toStdString(), HasSubstr("Select a vein or an artery"));
  EXPECT_FALSE(child<QWidget>("straightVessel")->isVisible());
  shared_->structures.add(kArtery);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return child<QLabel>("vesselReason")->text().contains(QStringLiteral("No center line")); }, kPatience_ms));
  shared_->structures.select(kVein);
  EXPECT_TRUE(QTest::qWaitFor([&] { return session_->course() != nullptr; }, kPatience_ms));
  EXPECT_TRUE(child<QWidget>("straightVessel")->isVisible());
}

TEST_F(Vessel, WheelAndKeysMoveAlongTheVesselAndRotate) {
  const Vec3 before_mm = shared_->crosshair.position_mm();
  wheel(-120);
  wheel(-120);
  const Vec3 after_mm = shared_->crosshair.position_mm();
  EXPECT_NEAR(after_mm.z, before_mm.z - 2 * session_->course()->step_mm(), 0.6) << "away from the head";
  QTest::keyClick(child<QWidget>("vesselPanel"), Qt::Key_Left);
  EXPECT_GT(shared_->crosshair.position_mm().z, after_mm.z);
  wheel(-120, Qt::ShiftModifier);
  EXPECT_NEAR(session_->angle_rad(), 5 * 3.14159 / 180, 1e-3);
  // The view follows the crosshair, too.
  shared_->crosshair.moveTo({0, 12, -5});
  EXPECT_NEAR(session_->course()->frames()[session_->frame()].center_mm.z, -5, 0.6);
}

TEST_F(Vessel, ADraggedOutlineIsOneStepThatIsPreviewedRecordedAndUndone) {
  const std::size_t veins = count(kVein);
  const int steps = shared_->openCase.undoStack().count();
  const double radius_mm = session_->outline().radius_mm[0];
  dragWall(25);
  EXPECT_TRUE(wasPreviewed_);
  EXPECT_GT(count(kVein), veins);
  EXPECT_GT(session_->outline().radius_mm[0], radius_mm + 1);
  EXPECT_NEAR(session_->outline().radius_mm[18], radius_mm, 0.3) << "the other side";
  ASSERT_EQ(shared_->openCase.undoStack().count(), steps + 1);
  const Recipe recipe = shared_->labeling.recipe();
  ASSERT_EQ(recipe.steps.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<step::Outline>(recipe.steps[0].tool));
  EXPECT_FALSE(shared_->labeling.preview().proposal());

  LabelMap again = patient()->labels;
  LabelEdit edit(patient()->ct, again);
  ASSERT_TRUE(perform(*readRecipe(textOf(recipe)), edit));
  EXPECT_EQ(again.voxels, labels().voxels) << "the recipe repeats it";
  shared_->openCase.undoStack().undo();
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
}

TEST_F(Vessel, ALockedVesselIsNotChangedAndAMessageSaysWhy) {
  shared_->labeling.setLocked(kVein, true);
  dragWall(25, 500);
  EXPECT_FALSE(wasPreviewed_);
  EXPECT_EQ(labels().voxels, patient()->labels.voxels);
  EXPECT_THAT(workspace_->statusText().toStdString(), HasSubstr("locked"));
}

TEST_F(Vessel, AClickOnAnotherSectionMovesThere) {
  const std::size_t before = session_->frame();
  const int side = sections().width() - 30;
  QTest::mouseClick(&sections(), Qt::LeftButton, {}, {side, (sections().height() - 18) / 2});
  EXPECT_GT(session_->frame(), before);
}

/// A vein with a leak to the patient's left, behind a neck of 3 mm.
std::shared_ptr<const PatientCase> leakingCase() {
  PatientCase patient = test::smallCase();
  const VolumeGeometry& g = patient.labels.geometry;
  const Transform patientFromIndex = g.patientFromIndex();
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at_mm = patientFromIndex * Vec3{double(i), double(j), double(k)} - Vec3{0, 12, 0};
        const bool isNeck = at_mm.x > 0 && at_mm.x < 14 && std::hypot(at_mm.y, at_mm.z) < 1.6;
        if (isNeck || norm(at_mm - Vec3{14, 0, 0}) < 4) patient.labels.at(i, j, k) = kVein;
      }
  return std::make_shared<const PatientCase>(std::move(patient));
}

TEST_F(Tools, AStrokeAcrossItsNeckCutsALeakOffAsOneStep) {
  const auto leaking = leakingCase();
  openCase(leaking);
  shared_->structures.select(kVein);
  shared_->crosshair.moveTo({0, 12, 0});
  QApplication::processEvents();
  child<QAction>("tool-cutoff")->trigger();
  // The second stroke replaces the first.
  drag({3, 4, 0}, {3, 8, 0});
  drag({8, 7, 0}, {8, 17, 0});
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->labeling.preview().proposal() != nullptr; }, kPatience_ms))
      << workspace_->statusText().toStdString();
  EXPECT_EQ(labels().voxels, leaking->labels.voxels) << "previewed only";
  key(Qt::Key_Return);
  ASSERT_TRUE(done());
  const auto at = [this](Vec3 patient_mm) {
    return sampleNearest(labels(), labels().geometry.indexFromPatient() * patient_mm);
  };
  EXPECT_EQ(at({14, 12, 0}), kSoftTissue);
  EXPECT_EQ(at({10, 12, 0}), kSoftTissue);
  EXPECT_EQ(at({6, 12, 0}), kVein);
  EXPECT_EQ(at({0, 12, 8}), kVein);
  EXPECT_THAT(workspace_->statusText().toStdString(), HasSubstr("ml changed"));
  child<QAction>("undo")->trigger();
  EXPECT_EQ(labels().voxels, leaking->labels.voxels);
  EXPECT_THAT(workspace_->statusText().toStdString(), testing::Not(HasSubstr("changed")));
}

}  // namespace
}  // namespace insonate::prepare
