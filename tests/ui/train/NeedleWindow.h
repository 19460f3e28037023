#pragma once

#include "TrainWindow.h"

#include <insonate/tissue/Labels.h>

#include <QStringList>
#include <cmath>

namespace insonate::train {

/// The workspace with a patient that has room for a needle beside the probe.
class NeedleWindow : public TrainWindow {
 protected:
  static constexpr const char* kWideTitle = "Wide block";

  /// As the small case, 100 mm wide and 50 mm long: skin at y = 0, a vein along z at 12 mm, bone from 26 mm on.
  static PatientCase wideCase() {
    VolumeGeometry grid;
    grid.size = {101, 41, 51};
    grid.origin_mm = {-50, -6, -25};
    PatientCase made{{}, CtVolume(grid, -1000), LabelMap(grid)};
    made.manifest.title = kWideTitle;
    made.manifest.startPoses = {{"over the vein", {0, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
    for (int k = 0; k < grid.size[2]; ++k)
      for (int j = 6; j < grid.size[1]; ++j)
        for (int i = 0; i < grid.size[0]; ++i) {
          const bool vein = std::hypot(i - 50, j - 18) < 5;
          const bool artery = i >= 88 && i < 93 && j >= 16 && j < 21;
          made.labels.at(i, j, k) = j < 8 ? kSkin : vein ? kVein : artery ? kArtery : j >= 32 ? kBone : kSoftTissue;
          made.ct.at(i, j, k) = 40;
        }
    return made;
  }
  void openWide() {
    static const auto wide = std::make_shared<const PatientCase>(wideCase());
    open(wide);
  }

  void open(const std::shared_ptr<const PatientCase>& patient) {
    ImagingSettings quick = model_->imaging.settings();
    quick.scanlines = 48, quick.samples = 200, quick.elevationPlanes = 1, quick.looks = 1;
    quick.width = 128, quick.height = 96;
    model_->imaging.setSettings(quick);
    said_.clear();
    QObject::connect(&hands(), &HapticControl::messageReported, workspace_.get(),
                     [this](const QString& words) { said_ << words; });
    workspace_->setCase(patient);
    ASSERT_TRUE(waitFor([&] { return workspace_->isReady() && model_->motion.isReady(); }));
    ASSERT_TRUE(waitFor([&] { return hands().session().isTissueGridReady(); }));
  }

  /// Taken up, square over the vein, 12 mm beside the probe.
  void overTheVein() {
    key(Qt::Key_I);
    hands().needleTo({0, 0, 12});
    type("needle_angle", "90");
    ASSERT_NEAR(held().entry_mm.z, 12, 0.5);
    ASSERT_NEAR(held().entry_mm.x, 0, 0.5);
  }

  void type(const char* field, const char* number) {
    auto* line = child<QLineEdit>(field);
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, number);
    QTest::keyClick(line, Qt::Key_Return);
  }
  bool waitFor(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience_ms); }
  HapticControl& hands() { return model_->hands; }
  const NeedlePlacementState& held() { return hands().needleHand()->state(); }
  NeedleState lying() { return hands().needle() ? hands().needle()->state : NeedleState{}; }
  /// Number of times that a sentence with these words was said.
  int heard(const char* words) { return int(said_.filter(words).size()); }

  QStringList said_;
};

}  // namespace insonate::train
