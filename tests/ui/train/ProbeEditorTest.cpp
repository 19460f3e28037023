#include "model/TrainModel.h"
#include "probe/FitCanvas.h"
#include "probe/FitDialog.h"
#include "probe/FovHandles.h"
#include "probe/ProbeEditor.h"
#include "probe/ProbeLibrary.h"

#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/View.h>

#include <gtest/gtest.h>
#include <support/FovCapture.h>
#include <support/SmallCase.h>
#include <support/TestData.h>
#include <ui/support/Patience.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTest>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace insonate::train {
namespace {

using test::kPatience_ms;

class ProbeEditing : public testing::Test {
 protected:
  void SetUp() override {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/probes";
    std::filesystem::remove_all(folder.toStdString());
    workspace_ = std::make_unique<TrainWorkspace>();
    workspace_->resize(1100, 700);
    workspace_->show();
    model_ = workspace_->findChild<TrainModel*>();
    editor_ = workspace_->findChild<ProbeEditor*>();
    handles_ = workspace_->findChild<FovHandles*>();
    ASSERT_TRUE(model_ && editor_ && handles_);
    canvas_ = workspace_->findChild<ui::ViewWidget*>("ultrasoundView")->focusProxy();
  }

  /// Small images of few scanlines, so that they come quickly.
  void openCase() {
    ImagingSettings quick = model_->imaging.settings();
    quick.scanlines = 48, quick.samples = 200, quick.elevationPlanes = 1, quick.looks = 1;
    quick.width = 128, quick.height = 96;
    model_->imaging.setSettings(quick);
    workspace_->setCase(std::make_shared<const PatientCase>(test::smallCase()));
    ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady() && model_->motion.isReady(); }, kPatience_ms));
  }
  void edit() {
    child<QPushButton>("editProbe")->click();
    EXPECT_TRUE(editor_->isVisible());
    EXPECT_TRUE(handles_->isActive());
  }
  /// Waits for an image of the probe and the depth as they are now, in a view that is as large as its canvas.
  void settle() {
    const views::View& view = child<ui::ViewWidget>("ultrasoundView")->view();
    QApplication::processEvents();
    ASSERT_TRUE(QTest::qWaitFor(
        [&] {
          const Probe &shown = model_->live.shown()->setup->probe, &wanted = model_->imaging.probe();
          const QSize canvas_px = canvas_->size() * canvas_->devicePixelRatioF();
          return shown.shape == wanted.shape && shown.fovAngle_deg == wanted.fovAngle_deg &&
                 shown.faceRadius_mm == wanted.faceRadius_mm &&
                 model_->live.shown()->setup->settings.depth_mm == model_->imaging.settings().depth_mm &&
                 QSize(view.width_px(), view.height_px()) == canvas_px;
        },
        kPatience_ms));
  }

  static void send(QWidget& widget, QEvent::Type type, QPointF at, bool held) {
    QMouseEvent event(type, at, widget.mapToGlobal(at.toPoint()),
                      type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton, held ? Qt::LeftButton : Qt::NoButton,
                      Qt::NoModifier);
    QApplication::sendEvent(&widget, &event);
  }
  static void drag(QWidget& widget, QPointF from, QPointF to) {
    send(widget, QEvent::MouseButtonPress, from, true);
    send(widget, QEvent::MouseMove, (from + to) / 2, true);
    send(widget, QEvent::MouseMove, to, true);
    send(widget, QEvent::MouseButtonRelease, to, false);
  }
  QPointF place(FovHandles::Handle handle) const {
    const views::DisplayPoint at = handles_->displayOf(handle);
    return QPointF(at.x, at.y) / canvas_->devicePixelRatioF();
  }

  template <class T>
  T* child(const char* name) {
    T* found = workspace_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  void rename(const char* name) {
    auto* line = child<QLineEdit>("probeName");
    line->setText(name);
    Q_EMIT line->editingFinished();
  }

  std::unique_ptr<TrainWorkspace> workspace_;
  TrainModel* model_ = nullptr;
  ProbeEditor* editor_ = nullptr;
  FovHandles* handles_ = nullptr;
  QWidget* canvas_ = nullptr;
};

TEST_F(ProbeEditing, EverySliderOfTheShapeReachesThePicture) {
  edit();
  for (const ProbeShape shape : {ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased}) {
    auto* shapes = child<QComboBox>("probeShape");
    shapes->setCurrentIndex(int(shape));
    Q_EMIT shapes->activated(int(shape));
    EXPECT_EQ(model_->imaging.probe().shape, shape);
    for (const ProbeField& field : probeFields()) {
      auto* slider = child<ui::ValueSlider>(std::string(field.name).c_str());
      ASSERT_TRUE(slider) << field.name;
      EXPECT_EQ(!slider->isHidden(), applies(field, shape)) << field.name;
      EXPECT_FALSE(slider->toolTip().isEmpty());
      if (!applies(field, shape)) continue;
      const double before = model_->imaging.probe().*field.member;
      slider->setValue(before * 0.98 + slider->range().step);
      EXPECT_EQ(editor_->draft().*field.member, slider->value()) << field.name;
      if (editor_->problem().isEmpty()) {
        EXPECT_EQ(model_->imaging.probe().*field.member, slider->value()) << field.name;
      }
      slider->setValue(before);
    }
  }
}

TEST_F(ProbeEditing, ApodizationReachesThePicture) {
  edit();
  auto* weights = child<QComboBox>("apodization");
  const Apodization before = model_->imaging.probe().apodization;
  EXPECT_EQ(weights->currentIndex(), int(before));
  for (const Apodization apodization : {Apodization::Hann, Apodization::Tukey, Apodization::Uniform}) {
    weights->setCurrentIndex(int(apodization));
    Q_EMIT weights->activated(int(apodization));
    EXPECT_EQ(model_->imaging.probe().apodization, apodization);
  }
  undoStep(model_->history, model_->status);
  EXPECT_EQ(model_->imaging.probe().apodization, before) << "changes of one control are undone as a whole";
  EXPECT_EQ(weights->currentIndex(), int(before));
}

TEST_F(ProbeEditing, WhatIsOutOfOrderIsSaidBesideTheControl) {
  edit();
  const double used = model_->imaging.probe().minDepth_mm;
  child<ui::ValueSlider>("minDepth_mm")->setValue(100);
  EXPECT_TRUE(editor_->problem().contains("depth")) << editor_->problem().toStdString();
  EXPECT_EQ(model_->imaging.probe().minDepth_mm, used) << "the picture goes on with the last valid probe";
  EXPECT_FALSE(child<QPushButton>("saveProbe")->isEnabled());
  child<ui::ValueSlider>("minDepth_mm")->setValue(10);
  EXPECT_TRUE(editor_->problem().isEmpty());
  EXPECT_EQ(model_->imaging.probe().minDepth_mm, 10);
}

TEST_F(ProbeEditing, DraggingHandlesChangesTheFieldOfView) {
  openCase();
  ASSERT_TRUE(model_->imaging.setProbe("curvilinear"));
  edit();
  settle();
  const double alpha = model_->imaging.probe().fovAngle_deg;
  QPointF from = place(FovHandles::Handle::RightSide);
  drag(*canvas_, from, from + QPointF(-40, 0));
  EXPECT_LT(model_->imaging.probe().fovAngle_deg, alpha - 3);
  EXPECT_EQ(child<ui::ValueSlider>("fovAngle_deg")->value(), model_->imaging.probe().fovAngle_deg);
  settle();
  const double narrower = model_->imaging.probe().fovAngle_deg;
  from = place(FovHandles::Handle::LeftSide);
  drag(*canvas_, from, from + QPointF(-20, 0));
  EXPECT_GT(model_->imaging.probe().fovAngle_deg, narrower + 1) << "outward on the other side";
  EXPECT_LT(model_->imaging.probe().fovAngle_deg, alpha + 10);
  settle();

  const double r1 = model_->imaging.probe().faceRadius_mm;
  from = place(FovHandles::Handle::Face);
  drag(*canvas_, from, from + QPointF(25, 0));
  EXPECT_GT(model_->imaging.probe().faceRadius_mm, r1 + 2);
  settle();
  const double depth = model_->imaging.settings().depth_mm;
  from = place(FovHandles::Handle::Depth);
  drag(*canvas_, from, from + QPointF(0, -60));
  EXPECT_LT(model_->imaging.settings().depth_mm, depth - 5);
  EXPECT_EQ(model_->imaging.probe().defaultDepth_mm, model_->imaging.settings().depth_mm);

  undoStep(model_->history, model_->status);
  EXPECT_EQ(model_->imaging.settings().depth_mm, depth) << "a drag is taken back as a whole";
  undoStep(model_->history, model_->status);
  EXPECT_EQ(model_->imaging.probe().faceRadius_mm, r1);
  redoStep(model_->history, model_->status);
  EXPECT_GT(model_->imaging.probe().faceRadius_mm, r1 + 2);
}

TEST_F(ProbeEditing, HandlesMoveByKeys) {
  openCase();
  edit();
  const double width = model_->imaging.probe().width_mm;
  QTest::keyClick(canvas_, Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(model_->imaging.probe().width_mm, width) << "none is chosen";
  QTest::keyClick(canvas_, Qt::Key_G);
  QTest::keyClick(canvas_, Qt::Key_Right, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_NEAR(model_->imaging.probe().width_mm, width + 5, 1e-9);
  QTest::keyClick(canvas_, Qt::Key_G);
  QTest::keyClick(canvas_, Qt::Key_G);
  const double depth = model_->imaging.settings().depth_mm;
  QTest::keyClick(canvas_, Qt::Key_Up, Qt::ControlModifier);
  EXPECT_NEAR(model_->imaging.settings().depth_mm, depth - 1, 1e-9) << "a straight face has no handle";
  child<QPushButton>("probeDone")->click();
  EXPECT_FALSE(handles_->isActive());
  EXPECT_FALSE(editor_->isVisible());
}

TEST_F(ProbeEditing, PresetsAreSavedRenamedDeletedAndRemembered) {
  edit();
  EXPECT_FALSE(child<QPushButton>("saveProbe")->isEnabled()) << "built-in probes stay as they are";
  rename("Ward 3");
  child<ui::ValueSlider>("width_mm")->setValue(44);
  child<QPushButton>("saveProbe")->click();
  auto* list = child<QComboBox>("probe");
  EXPECT_EQ(list->currentText(), "Ward 3");
  EXPECT_EQ(list->count(), 4);
  child<ui::ValueSlider>("width_mm")->setValue(50);
  EXPECT_EQ(list->currentText(), "Ward 3, edited");
  child<QPushButton>("resetProbe")->click();
  EXPECT_EQ(model_->imaging.probe().width_mm, 44);
  EXPECT_EQ(list->currentText(), "Ward 3");

  const test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  EXPECT_EQ(other.findChild<TrainModel*>()->imaging.probe().name, "Ward 3");
  EXPECT_EQ(other.findChild<TrainModel*>()->imaging.probe().width_mm, 44);

  rename("Ward 4");
  child<QPushButton>("renameProbe")->click();
  EXPECT_EQ(list->count(), 4);
  EXPECT_EQ(list->currentText(), "Ward 4");
  child<QPushButton>("deleteProbe")->click();
  EXPECT_EQ(list->count(), 4) << "three built-in, and the one in use";
  EXPECT_EQ(list->currentText(), "Ward 4, edited");
  model_->imaging.setProbe("linear");
  EXPECT_EQ(list->count(), 3);
}

/// A capture of a machine.
QImage captured(double mark_px) {
  test::FovCapture capture;
  capture.shape.shape = ProbeShape::Curvilinear;
  capture.shape.origin = {480, -20}, capture.shape.alpha_deg = 60, capture.shape.r1_px = 160, capture.shape.r2_px = 680;
  capture.text = true, capture.mark_px = mark_px;
  const GrayImage picture = test::paint(capture);
  return QImage(picture.gray.data(), picture.width, picture.height, picture.width, QImage::Format_Grayscale8).copy();
}

TEST_F(ProbeEditing, APictureBecomesTheProbe) {
  const test::TemporaryFolder folder;
  const QString file = QString::fromStdString((folder / "capture.png").string());
  ASSERT_TRUE(captured(40).save(file));
  openCase();
  edit();
  auto* name = child<QLineEdit>("probeName");
  name->selectAll();
  QTest::keyClicks(name, "Ward 9");
  child<QPushButton>("fitToPicture")->click();
  auto* dialog = workspace_->findChild<FitDialog*>();
  ASSERT_TRUE(dialog);
  EXPECT_FALSE(dialog->findChild<QPushButton*>("fitTake")->isEnabled());
  dialog->openPicture(file);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog->isWorking(); }, kPatience_ms));
  auto* fit = dialog->findChild<FitCanvas*>();
  ASSERT_TRUE(fit->shape()) << dialog->message().toStdString();
  EXPECT_NEAR(fit->shape()->alpha_deg, 60, 1);
  EXPECT_NEAR(dialog->findChild<ui::ValueSlider*>("fitDepth")->value(), 130, 2.6);

  const QPointF from = fit->placeOf(FitCanvas::Handle::RightCorner);
  drag(*fit, from, from + QPointF(30, -20));
  EXPECT_GT(fit->shape()->alpha_deg, 62) << "corners can be corrected";
  dialog->findChild<ui::ValueSlider*>("fitDepth")->setValue(100);
  dialog->findChild<QPushButton*>("fitTake")->click();
  EXPECT_EQ(model_->imaging.probe().shape, ProbeShape::Curvilinear);
  EXPECT_EQ(name->text(), "Ward 9") << "typed without Enter";
  EXPECT_GT(model_->imaging.probe().fovAngle_deg, 62);
  EXPECT_NEAR(model_->imaging.settings().depth_mm, 100, 0.1);
  EXPECT_NEAR(editor_->draft().faceRadius_mm, model_->imaging.probe().faceRadius_mm, 0.06);
  EXPECT_TRUE(editor_->problem().isEmpty());
  EXPECT_TRUE(child<QPushButton>("saveProbe")->isEnabled());
}

TEST_F(ProbeEditing, TwoMarksOfThePictureGiveItsScale) {
  FitDialog dialog(model_->imaging.probe());
  dialog.show();
  QApplication::clipboard()->setImage(captured(0));
  dialog.paste();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, kPatience_ms));
  auto* fit = dialog.findChild<FitCanvas*>();
  auto* apart = dialog.findChild<ui::ValueSlider*>("fitLine");
  auto* depth = dialog.findChild<ui::ValueSlider*>("fitDepth");
  ASSERT_TRUE(fit->shape());
  const double alpha = fit->shape()->alpha_deg;
  EXPECT_FALSE(apart->isVisible());
  const auto click = [&](PixelPoint at) {
    send(*fit, QEvent::MouseButtonPress, fit->placeOf(at), true);
    send(*fit, QEvent::MouseButtonRelease, fit->placeOf(at), false);
  };
  auto* draw = dialog.findChild<QPushButton*>("fitDraw");
  draw->click();
  click({500, 200});
  click({500, 200});
  EXPECT_FALSE(apart->isVisible());
  EXPECT_TRUE(dialog.message().contains("same")) << dialog.message().toStdString();
  draw->click();
  click({500, 200});
  click({500, 400});
  ASSERT_TRUE(apart->isVisible());
  EXPECT_EQ(fit->shape()->alpha_deg, alpha) << "no handle was taken";
  apart->setValue(50);
  EXPECT_NEAR(depth->value(), depthOf_px(*fit->shape()) * 50 / 200, 0.3);
  depth->setValue(100);
  EXPECT_NEAR(apart->value(), 200 * 100 / depthOf_px(*fit->shape()), 0.3) << "what is typed last decides";
  draw->click();
  drag(*fit, fit->placeOf({300, 200}), fit->placeOf({300, 300}));
  EXPECT_NEAR(apart->value(), 100 * 100 / depthOf_px(*fit->shape()), 0.3) << "or by dragging";
}

TEST_F(ProbeEditing, ChangesAreTakenBackWithoutACase) {
  edit();
  const double before = model_->imaging.probe().width_mm;
  child<ui::ValueSlider>("width_mm")->setValue(before + 6);
  QTest::keyClick(workspace_.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(model_->imaging.probe().width_mm, before);
  QTest::keyClick(workspace_.get(), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(model_->imaging.probe().width_mm, before + 6);
  const test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  auto* restored = other.findChild<TrainModel*>();
  const Probe as = restored->imaging.probe();
  undoStep(restored->history, restored->status);
  EXPECT_EQ(restored->imaging.probe().width_mm, as.width_mm) << "how it was left is not taken back";
}

TEST_F(ProbeEditing, PastedDroppedBadAndCancelled) {
  const Probe before = model_->imaging.probe();
  FitDialog dialog(before);
  dialog.show();
  QApplication::clipboard()->setText("no image");
  dialog.paste();
  EXPECT_TRUE(dialog.message().contains("clipboard"));
  const test::TemporaryFolder folder;
  std::ofstream(folder / "notes.txt") << "no image";
  dialog.openPicture(QString::fromStdString((folder / "notes.txt").string()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, kPatience_ms));
  EXPECT_TRUE(dialog.message().contains("not an image that can be read")) << dialog.message().toStdString();

  QImage black(640, 480, QImage::Format_RGB32);
  black.fill(Qt::black);
  QApplication::clipboard()->setImage(black);
  dialog.paste();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, kPatience_ms));
  EXPECT_TRUE(dialog.message().contains("No field of view was found"));
  EXPECT_TRUE(dialog.findChild<FitCanvas*>()->shape()) << "to be placed by hand";
  dialog.openPicture(QString::fromStdString((folder / "notes.txt").string()));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !dialog.isWorking(); }, kPatience_ms));
  EXPECT_TRUE(dialog.message().contains("not an image that can be read"));
  EXPECT_TRUE(std::ranges::any_of(dialog.findChildren<QLabel*>(), [](const QLabel* label) {
    return label->isVisible() && label->text().startsWith("No field of view was found");
  })) << "what is said of the picture before, which is still shown";

  QApplication::clipboard()->setImage(captured(0));
  dialog.paste();
  EXPECT_TRUE(dialog.isWorking()) << "the window goes on";
  dialog.reject();
  EXPECT_EQ(dialog.probe().name, before.name);
  EXPECT_EQ(dialog.probe().width_mm, before.width_mm);
}

}  // namespace
}  // namespace insonate::train
