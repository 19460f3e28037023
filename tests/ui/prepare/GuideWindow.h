#pragma once

#include "PrepareWindow.h"
#include "guide/GuideSession.h"

#include <gmock/gmock.h>

#include <QTabBar>
#include <QTreeWidget>

namespace insonate::prepare {

using State = GuideSession::State;
using testing::HasSubstr;

inline constexpr double kArtery_x = -14;

/// The small block with contrast agent in a vein and an artery that nobody has labeled.
inline std::shared_ptr<const PatientCase> unlabeled() {
  static const auto made = [] {
    auto patient = std::make_shared<PatientCase>(test::smallCase());
    const VolumeGeometry& grid = patient->ct.geometry;
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 8; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          const Vec3 p = grid.patientFromIndex() * Vec3{double(i), double(j), double(k)};
          const bool vein = std::hypot(p.x, p.y - 12) < 5, artery = std::hypot(p.x - kArtery_x, p.y - 12) < 2.2;
          if (patient->labels.at(i, j, k) != kBone) patient->labels.at(i, j, k) = kSoftTissue;
          patient->ct.at(i, j, k) = vein ? 180 : artery ? 260 : 45;
        }
    return patient;
  }();
  return made;
}

/// The workspace with the guide in front.
class Guiding : public PrepareWindow {
 protected:
  void SetUp() override {
    PrepareWindow::SetUp();
    openCase(unlabeled());
    child<QTabBar>("labelling")->setCurrentIndex(0);
    guide_ = workspace_->findChild<GuideSession*>();
    ASSERT_TRUE(guide_);
  }
  void choose(const char* name) {
    auto* list = child<QTreeWidget>("guideSteps");
    for (std::size_t n = 0; n < guide_->steps().size(); ++n)
      if (guide_->steps()[n].name == name) {
        list->scrollToItem(list->topLevelItem(int(n)));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                          list->visualItemRect(list->topLevelItem(int(n))).center());
      }
    ASSERT_EQ(guide_->step().name, name);
  }
  QPoint placeOf(Vec3 patient_mm) {
    shared_->crosshair.moveTo(patient_mm);
    const views::DisplayPoint at = axial().displayFromPatient(patient_mm);
    const double ratio = canvas("Axial slice")->devicePixelRatioF();
    return {int(at.x / ratio), int(at.y / ratio)};
  }
  void click(Vec3 patient_mm, Qt::MouseButton button = Qt::LeftButton) {
    QTest::mouseClick(canvas("Axial slice"), button, {}, placeOf(patient_mm));
  }
  void drag(Vec3 from_mm, Vec3 to_mm, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QWidget* slice = canvas("Axial slice");
    const QPoint from = placeOf(from_mm), to = placeOf(to_mm);
    QTest::mousePress(slice, Qt::LeftButton, keys, from);
    QMouseEvent move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, keys);
    QCoreApplication::sendEvent(slice, &move);
    QTest::mouseRelease(slice, Qt::LeftButton, keys, to);
  }
  void run() {
    child<QPushButton>("guideRun")->click();
    ASSERT_TRUE(QTest::qWaitFor([&] { return !guide_->isBusy(); }, kPatience_ms));
  }
  void makeVein(double aside = 0) {
    choose("vein-right");
    click({aside, 12, -7});
    click({aside, 12, 7});
    run();
  }
  void makeArtery() {
    choose("artery-right");
    click({kArtery_x, 12, -7});
    click({kArtery_x, 12, 7});
    run();
  }
  void save(const std::filesystem::path& folder) {
    auto saved = std::make_shared<PatientCase>(*shared_->openCase.patient());
    workspace_->unsavedEdit()(*saved);
    ASSERT_TRUE(writeCase(*saved, folder));
    ui::CaseOrigin origin;
    origin.folder = QString::fromStdString(folder.string());
    workspace_->setOrigin(origin);
    workspace_->caseSaved(saved);
  }
  void saveAndOpenAgain(const std::filesystem::path& folder) {
    save(folder);
    auto back = readCase(folder);
    ASSERT_TRUE(back) << back.error().message;
    openCase(std::make_shared<const PatientCase>(std::move(back->patient)));
  }
  std::size_t count(std::uint8_t label) {
    return std::size_t(std::ranges::count(shared_->labeling.labels().voxels, label));
  }
  const std::vector<std::uint8_t>& voxels() { return shared_->labeling.labels().voxels; }

  GuideSession* guide_ = nullptr;
};

}  // namespace insonate::prepare
