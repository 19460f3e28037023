#pragma once

#include "model/TrainModel.h"

#include <insonate/simulator/ProbePose.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QImage>
#include <QLineEdit>
#include <QListWidget>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <memory>

namespace insonate::train {

using test::kPatience_ms;

class TrainWindow : public testing::Test {
 protected:
  void SetUp() override {
    workspace_ = std::make_unique<TrainWorkspace>();
    workspace_->resize(1100, 700);
    workspace_->show();
    model_ = workspace_->findChild<TrainModel*>();
    ASSERT_TRUE(model_);
    // Vessels that move all the time let no image be the last one.
    TissueChoice still = model_->imaging.tissue();
    still.pulse = still.breathing = false;
    model_->imaging.setTissue(still);
    model_->history.clear();
    canvas_ = workspace_->findChild<ui::ViewWidget*>("ultrasoundView")->focusProxy();
  }

  static std::shared_ptr<const PatientCase> patient() {
    static const auto made = std::make_shared<const PatientCase>(test::smallCase());
    return made;
  }

  /// Small images of few scanlines, so that they come quickly.
  void openCase() {
    ImagingSettings quick = model_->imaging.settings();
    quick.scanlines = 48, quick.samples = 200, quick.elevationPlanes = 1, quick.looks = 1;
    quick.width = 128, quick.height = 96;
    model_->imaging.setSettings(quick);
    workspace_->setCase(patient());
    ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady() && model_->motion.isReady(); }, kPatience_ms))
        << workspace_->statusText().toStdString();
  }

  void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) { QTest::keyClick(canvas_, key, modifiers); }

  /// QTest moves the screen's pointer instead, which is not there when two windows share the screen.
  void drag(Qt::MouseButton button, QPoint from, QPoint to) {
    const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton what, Qt::MouseButtons held) {
      QMouseEvent event(type, at, canvas_->mapToGlobal(at), what, held, Qt::NoModifier);
      QApplication::sendEvent(canvas_, &event);
    };
    send(QEvent::MouseButtonPress, from, button, button);
    send(QEvent::MouseMove, to, Qt::NoButton, button);
    send(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
  }

  /// Waits until the image on display is of the pose and settings as they are now, in full quality.
  void settle() {
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          return model_->live.shown()->patientFromProbe == model_->motion.pose() && !model_->live.shown()->isCoarse &&
                 model_->live.shown()->setup->settings.depth_mm == model_->imaging.settings().depth_mm;
        },
        kPatience_ms));
  }

  template <class T>
  T* child(const char* name) {
    T* found = workspace_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }

  std::unique_ptr<TrainWorkspace> workspace_;
  TrainModel* model_ = nullptr;
  QWidget* canvas_ = nullptr;
};

}  // namespace insonate::train
