#include <insonate/tissue/Labels.h>
#include <insonate/ui/HistogramEditor.h>
#include <insonate/ui/ScenePanel.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/ViewWidget.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>
#include <QtTest/QTest>

namespace insonate::ui {
namespace {

using views::ClippingKind;
using views::SceneView;
using views::Stereo;

/// A tetrahedron of some millimeters.
void addSurface(SceneView& scene, std::uint8_t label) {
  const float size = 10.F + label;
  const float points[] = {0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size};
  const std::uint32_t triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  scene.setSurface(label, {points, {}, triangles});
}

class ScenePanel : public testing::Test {
 protected:
  ScenePanel() : scene(std::make_shared<SceneView>()) {
    patient = std::make_shared<const PatientCase>(test::smallCase());
    shown = std::make_shared<views::VtkCase>(patient);
    scene->setCase(shown);
    auto* box = new QHBoxLayout(&window);
    view = new ViewWidget(scene, "scene");
    panel = new ui::ScenePanel(scene);
    auto* scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    box->addWidget(view, 1);
    box->addWidget(scroll, 1);
    window.resize(760, 620);
    for (const Label label : {kSkin, kArtery, kVein, kBone}) addSurface(*scene, label);
    panel->setCase(patient);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);
    QTest::qWait(50);
  }

  template <class T>
  T* child(const char* name) {
    T* found = panel->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  void choose(const char* name, int data) {
    auto* combo = child<QComboBox>(name);
    const int index = combo->findData(data);
    ASSERT_GE(index, 0);
    combo->setCurrentIndex(index);
    Q_EMIT combo->activated(index);
  }
  bool settles() {
    return QTest::qWaitFor([&] { return !scene->isMoving(); }, 20000);
  }

  std::shared_ptr<const PatientCase> patient;
  std::shared_ptr<const views::VtkCase> shown;
  std::shared_ptr<SceneView> scene;
  QWidget window;
  ViewWidget* view = nullptr;
  ui::ScenePanel* panel = nullptr;
};

TEST_F(ScenePanel, SkinTransparencyIsOnTopAndDrawnCoarserWhileItMoves) {
  auto* skin = child<ValueSlider>("skinTransparency");
  EXPECT_NEAR(skin->value(), 65, 1e-9);
  skin->setValue(90);
  EXPECT_NEAR(scene->opacity(kSkin), 0.1, 1e-9);
  EXPECT_TRUE(scene->isMoving());
  EXPECT_TRUE(settles()) << "the exact picture follows";
  scene->setSkinOpacity(0.5);
  EXPECT_TRUE(QTest::qWaitFor([&] { return skin->value() == 50; }, 5000)) << "others may change it, too";
}

TEST_F(ScenePanel, StructuresAreListedHiddenColoredAndMadeTranslucent) {
  child<QToolButton>("eye6")->click();
  EXPECT_FALSE(scene->isVisible(kVein));
  EXPECT_TRUE(scene->isVisible(kArtery));
  auto* opacity = child<QSpinBox>("opacity12");
  opacity->setFocus();
  opacity->selectAll();
  QTest::keyClicks(opacity, "40");
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_NEAR(scene->opacity(kBone), 0.4, 1e-9);
  QSignalSpy colors(panel, &ui::ScenePanel::colorsChanged);
  child<QToolButton>("colour2")->click();
  auto* dialog = panel->findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setCurrentColor(QColor(1, 2, 3));
  dialog->accept();
  EXPECT_EQ(scene->color(kArtery), (views::Color{1, 2, 3}));
  EXPECT_EQ(colors.count(), 1);

  child<QToolButton>("structuresNone")->click();
  for (const auto label : scene->structures()) EXPECT_FALSE(scene->isVisible(label));
  EXPECT_TRUE(QTest::qWaitFor([&] { return !child<QToolButton>("eye2")->isChecked(); }, 5000));
  child<QToolButton>("structuresAll")->click();
  for (const auto label : scene->structures()) EXPECT_TRUE(scene->isVisible(label));
  child<QToolButton>("structuresUsual")->click();
  EXPECT_EQ(scene->opacity(kBone), 1);
  EXPECT_EQ(scene->color(kArtery), views::labelColor(kArtery, views::ColorScheme::Default));
}

TEST_F(ScenePanel, WhatAnOpacityDoesNotTakeIsSaid) {
  auto* opacity = child<QSpinBox>("opacity12");
  const auto type = [&](const char* text) {
    QToolTip::hideText();
    EXPECT_TRUE(QTest::qWaitFor([] { return QToolTip::text().isEmpty(); }, 5000));
    opacity->setFocus();
    opacity->selectAll();
    QTest::keyClicks(opacity, text);
  };
  type("a");
  EXPECT_TRUE(QToolTip::text().endsWith("takes a number from 0 % to 100 %.")) << QToolTip::text().toStdString();
  type("4x0");
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_EQ(opacity->value(), 40) << "the rest of it counts";
  type("500");
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_EQ(opacity->text(), "100 %");
  EXPECT_NEAR(scene->opacity(kBone), 1, 1e-9);
  EXPECT_TRUE(QToolTip::text().endsWith("must be from 0 % to 100 %; 500 % is outside this range."))
      << QToolTip::text().toStdString();
  type("30 %");
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_NEAR(scene->opacity(kBone), 0.3, 1e-9);
  EXPECT_TRUE(QToolTip::text().isEmpty()) << QToolTip::text().toStdString();
}

TEST_F(ScenePanel, ScrollingPastANumberDoesNotChangeIt) {
  auto* opacity = child<QSpinBox>("opacity12");
  const auto wheel = [&] {
    QWheelEvent event({5, 5}, opacity->mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(opacity, &event);
  };
  child<QToolButton>("eye6")->setFocus();
  wheel();
  EXPECT_EQ(scene->opacity(kBone), 1);
  opacity->setFocus();
  wheel();
  EXPECT_LT(scene->opacity(kBone), 1);
}

TEST_F(ScenePanel, RowsFollowTheSurfaces) {
  addSurface(*scene, kThyroid);
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel->findChild<QToolButton*>("eye8") != nullptr; }, 5000));
  scene->setSurface(kThyroid, {});
  EXPECT_TRUE(QTest::qWaitFor([&] { return panel->findChild<QToolButton*>("eye8") == nullptr; }, 5000));
}

TEST_F(ScenePanel, ColorBlindSafeColorsAreAnOption) {
  child<QCheckBox>("safeColours")->click();
  EXPECT_EQ(scene->color(kVein), views::labelColor(kVein, views::ColorScheme::ColorBlindSafe));
  child<QToolButton>("structuresUsual")->click();
  EXPECT_EQ(scene->color(kVein), views::labelColor(kVein, views::ColorScheme::ColorBlindSafe)) << "stays an option";
  child<QCheckBox>("safeColours")->click();
  EXPECT_EQ(scene->color(kVein), views::labelColor(kVein, views::ColorScheme::Default));
}

TEST_F(ScenePanel, TheCtIsShownAndItsLookEdited) {
  EXPECT_FALSE(panel->histogram().isVisible()) << "takes no room until it is wanted";
  child<QCheckBox>("ctVolume")->click();
  EXPECT_TRUE(scene->isCtVisible());
  EXPECT_TRUE(panel->histogram().isVisible());
  EXPECT_TRUE(QTest::qWaitFor([&] { return !panel->histogram().visibleRegion().isEmpty(); }, 5000));
  panel->histogram().choosePreset("lung");
  EXPECT_EQ(scene->transferFunction(), views::transferPresets()[4].function);
  EXPECT_TRUE(scene->isMoving());
  EXPECT_TRUE(settles());
}

TEST_F(ScenePanel, TheClippingPlaneIsChosenMovedAndTurned) {
  EXPECT_FALSE(child<ValueSlider>("clippingOffset")->isVisible());
  choose("clippingKind", int(ClippingKind::Coronal));
  auto* offset = child<ValueSlider>("clippingOffset");
  EXPECT_TRUE(offset->isVisible());
  EXPECT_FALSE(child<ValueSlider>("clippingTurn")->isVisible());
  offset->setValue(7);
  ASSERT_TRUE(scene->clippingPlane());
  const Vec3 middle = patient->ct.geometry.center_mm();
  EXPECT_NEAR(scene->clippingPlane()->point_mm.y, middle.y + 7, 1e-6);
  EXPECT_EQ(scene->clippingPlane()->normal.y, 1);
  child<QCheckBox>("clippingFlipped")->click();
  EXPECT_EQ(scene->clippingPlane()->normal.y, -1);

  choose("clippingKind", int(ClippingKind::Free));
  EXPECT_EQ(offset->value(), 0) << "another plane starts in the middle";
  child<QCheckBox>("clippingFlipped")->click();
  child<ValueSlider>("clippingTurn")->setValue(90);
  EXPECT_NEAR(scene->clippingPlane()->normal.x, 1, 1e-9);
  child<ValueSlider>("clippingTilt")->setValue(90);
  EXPECT_NEAR(scene->clippingPlane()->normal.z, 1, 1e-9);
  scene->setViewpoint(views::Viewpoint::Left);
  view->view().render();
  child<QToolButton>("clippingAsSeen")->click();
  EXPECT_NEAR(scene->clippingPlane()->normal.x, -1, 1e-6) << "what is before it, seen from the left, is cut away";
  EXPECT_NEAR(child<ValueSlider>("clippingTurn")->value(), -90, 1e-6);
  choose("clippingKind", int(ClippingKind::Off));
  EXPECT_FALSE(scene->clippingPlane());
}

TEST_F(ScenePanel, StereoOffersWhatTheWindowCan) {
  auto* combo = child<QComboBox>("stereo");
  EXPECT_LT(combo->findData(int(Stereo::QuadBuffer)), 0) << "this window was not made for shutter glasses";
  for (const Stereo mode : {Stereo::Anaglyph, Stereo::SideBySide, Stereo::Interlaced, Stereo::Checkerboard,
                            Stereo::LeftEye, Stereo::RightEye, Stereo::Off}) {
    choose("stereo", int(mode));
    EXPECT_EQ(scene->stereo(), mode);
    const int before = view->renderings();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view->renderings() > before; }, 20000));
  }
}

TEST_F(ScenePanel, TheEyeIsEntered) {
  EXPECT_FALSE(child<ValueSlider>("eyeRight")->isVisible());
  child<QCheckBox>("headCoupled")->click();
  EXPECT_TRUE(child<ValueSlider>("eyeRight")->isVisible());
  EXPECT_FALSE(child<ValueSlider>("eyeSeparation")->isVisible()) << "nothing without stereo";
  child<ValueSlider>("eyeRight")->setValue(-120);
  child<ValueSlider>("eyeUp")->setValue(40);
  child<ValueSlider>("eyeDistance")->setValue(450);
  child<ValueSlider>("eyeWidth")->setValue(300);
  ASSERT_TRUE(scene->headCoupling());
  EXPECT_EQ(scene->headCoupling()->eye_mm, (Vec3{-120, 40, 450}));
  EXPECT_EQ(scene->headCoupling()->width_mm, 300);
  child<QCheckBox>("headCoupled")->click();
  EXPECT_FALSE(scene->headCoupling());
}

TEST_F(ScenePanel, StructuresLookAsTheCasesAuthorChose) {
  constexpr views::Color kAuthors{10, 220, 40}, kOwn{1, 2, 3};
  scene->setColor(kBone, kOwn);
  scene->setOpacity(kVein, 0.7);
  PatientCase authored = test::smallCase();
  authored.colors = {{kVein, {10, 220, 40}}};
  authored.manifest.shown = {{kVein, {0.4, true}}, {kArtery, {1, false}}};
  QSignalSpy colored(panel, &ui::ScenePanel::colorsChanged);
  panel->setCase(std::make_shared<const PatientCase>(authored));
  EXPECT_EQ(scene->color(kVein), kAuthors);
  EXPECT_NEAR(scene->opacity(kVein), 0.4, 1e-9);
  EXPECT_FALSE(scene->isVisible(kArtery));
  EXPECT_EQ(scene->color(kBone), kOwn) << "what the author has no wish for is the user's";
  EXPECT_EQ(colored.count(), 1) << "slices have the colours, too";

  scene->setVisible(kArtery, true);
  child<QToolButton>("structuresUsual")->click();
  EXPECT_FALSE(scene->isVisible(kArtery)) << "as the author chose";
  EXPECT_EQ(scene->color(kVein), kAuthors);
  child<QCheckBox>("safeColours")->click();
  EXPECT_EQ(scene->color(kVein), views::labelColor(kVein, views::ColorScheme::ColorBlindSafe));
  child<QCheckBox>("safeColours")->click();
  EXPECT_EQ(scene->color(kVein), kAuthors);

  const QTemporaryDir folder;
  QSettings settings(folder.filePath("layout.ini"), QSettings::IniFormat);
  panel->save(settings);
  panel->setCase(patient);
  EXPECT_EQ(scene->color(kVein), views::labelColor(kVein, views::ColorScheme::Default));
  EXPECT_NEAR(scene->opacity(kVein), 0.7, 1e-9) << "the user's own again";
  EXPECT_TRUE(scene->isVisible(kArtery));
  auto other = std::make_shared<SceneView>();
  ui::ScenePanel again(other);
  again.restore(settings);
  EXPECT_NEAR(other->opacity(kVein), 0.7, 1e-9) << "a case's looks are not remembered for others";
  EXPECT_TRUE(other->isVisible(kArtery));
}

TEST_F(ScenePanel, AnotherPatientHasSkinAgainAndNoCt) {
  child<QToolButton>("eye1")->click();
  child<QCheckBox>("ctVolume")->click();
  child<QToolButton>("eye6")->click();
  ASSERT_FALSE(scene->isVisible(kSkin) || scene->isVisible(kVein));
  panel->setCase(std::make_shared<const PatientCase>(test::smallCase()));
  EXPECT_FALSE(scene->isVisible(kSkin)) << "saved, it is still the same patient";
  EXPECT_TRUE(scene->isCtVisible());
  PatientCase other = test::smallCase();
  other.manifest.source = "another patient";
  panel->setCase(nullptr);
  panel->setCase(std::make_shared<const PatientCase>(other));
  EXPECT_TRUE(scene->isVisible(kSkin));
  EXPECT_FALSE(scene->isCtVisible());
  EXPECT_FALSE(scene->isVisible(kVein)) << "that stays as the user has it";
}

TEST_F(ScenePanel, SkinHasOneControlAndAnEyeOfNothingSaysSo) {
  auto* eye = child<QToolButton>("eye6");
  EXPECT_TRUE(eye->toolTip().startsWith("Show or hide"));
  scene->setOpacity(kVein, 0);
  QTest::qWait(20);
  EXPECT_TRUE(eye->toolTip().contains("is invisible")) << eye->toolTip().toStdString();
  EXPECT_TRUE(child<QSpinBox>("opacity6")->isVisible());
  EXPECT_FALSE(child<QSpinBox>("opacity1")->isVisible()) << "the slider above is for that";
}

TEST_F(ScenePanel, IsRememberedButForTheClippingPlane) {
  child<QToolButton>("eye6")->click();
  scene->setOpacity(kBone, 0.25);
  child<QCheckBox>("safeColours")->click();
  panel->histogram().choosePreset("skin and bone");
  child<QCheckBox>("headCoupled")->click();
  child<ValueSlider>("eyeWidth")->setValue(777);
  choose("clippingKind", int(ClippingKind::Axial));
  const QTemporaryDir folder;
  QSettings settings(folder.filePath("layout.ini"), QSettings::IniFormat);
  panel->save(settings);

  auto other = std::make_shared<SceneView>();
  ui::ScenePanel again(other);
  again.restore(settings);
  EXPECT_FALSE(other->isVisible(kVein));
  EXPECT_NEAR(other->opacity(kBone), 0.25, 1e-9);
  EXPECT_EQ(again.colorScheme(), views::ColorScheme::ColorBlindSafe);
  EXPECT_EQ(other->color(kArtery), views::labelColor(kArtery, views::ColorScheme::ColorBlindSafe));
  EXPECT_EQ(other->transferFunction(), views::transferPresets()[2].function);
  EXPECT_FALSE(other->clippingPlane());
  EXPECT_EQ(again.findChild<ValueSlider*>("eyeWidth")->value(), 777);

  settings.setValue("structures", "nonsense");
  settings.setValue("transferFunction", "{");
  again.restore(settings);
  EXPECT_EQ(other->transferFunction(), views::transferPresets()[2].function) << "what cannot be read changes nothing";
}

}  // namespace
}  // namespace insonate::ui
