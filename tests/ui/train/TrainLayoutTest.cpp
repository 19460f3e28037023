#include "TrainWindow.h"
#include "patient3d/FourSlices.h"

#include <insonate/views/MprView.h>
#include <insonate/views/UltrasoundView.h>

#include <ui/support/WholeWords.h>

#include <QAction>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <QWheelEvent>

namespace insonate::train {
namespace {

/// Panels beside the image, and their places.
class TrainLayout : public TrainWindow {
 protected:
  ui::ViewWidget* beside() { return child<ui::ViewWidget>("ctBeside"); }
  ui::ViewWidget* picture() { return child<ui::ViewWidget>("ultrasoundView"); }
  views::MprView& slice(ui::ViewWidget* widget) { return static_cast<views::MprView&>(widget->view()); }
  views::UltrasoundView& ultrasound() { return static_cast<views::UltrasoundView&>(picture()->view()); }
  QPoint logical(views::DisplayPoint at) { return {int(at.x / ratio()), int(at.y / ratio())}; }
  double ratio() { return canvas_->devicePixelRatioF(); }

  void point(QWidget* canvas, QPoint at) {
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QApplication::sendEvent(canvas, &move);
  }
  QAction* action(const QString& begin) {
    for (QAction* one : workspace_->actions())
      if (one->text().startsWith(begin)) return one;
    ADD_FAILURE() << begin.toStdString();
    return nullptr;
  }
  ui::ViewWidget* mpr() {
    for (auto* one : workspace_->findChildren<ui::ViewWidget*>())
      if (one->accessibleName() == "CT slice") return one;
    return nullptr;
  }
};

TEST_F(TrainLayout, TheCtStandsBesideThePictureAtTheSameScale) {
  openCase();
  EXPECT_FALSE(beside()->isVisible());
  key(Qt::Key_C);
  ASSERT_TRUE(QTest::qWaitFor([&] { return beside()->isVisible() && beside()->width() == picture()->width(); }));
  EXPECT_TRUE(child<QPushButton>("ctBesideButton")->isChecked());
  EXPECT_TRUE(action("CT beside")->isChecked());
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return std::abs(1 / slice(beside()).plane().mm_per_px - ultrasound().px_per_mm()) < 1e-6; }));
  const auto same = [&] {
    const Vec3 place = model_->live.shown()->patientFromProbe * Vec3{5, 0, 15};
    const views::DisplayPoint here = slice(beside()).displayFromPatient(place);
    const views::DisplayPoint there = ultrasound().displayFromImage({5, 15});
    return std::hypot(here.x - there.x, here.y - there.y) < 1e-3;
  };
  EXPECT_TRUE(same());
  EXPECT_GT(beside()->y(), picture()->y()) << "below it, where that makes both larger";
  workspace_->resize(1800, 700);
  EXPECT_TRUE(QTest::qWaitFor([&] { return beside()->x() > picture()->x(); }, 5000));
  EXPECT_EQ(beside()->size(), picture()->size());
  EXPECT_TRUE(QTest::qWaitFor(same, 5000));
  key(Qt::Key_Right, Qt::ShiftModifier);
  key(Qt::Key_E, Qt::ShiftModifier);
  settle();
  EXPECT_TRUE(QTest::qWaitFor(same, 5000)) << "it follows the probe";
  child<QPushButton>("ctBesideButton")->click();
  EXPECT_FALSE(beside()->isVisible());
}

TEST_F(TrainLayout, PointingInOneMarksTheOther) {
  openCase();
  key(Qt::Key_C);
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return std::abs(1 / slice(beside()).plane().mm_per_px - ultrasound().px_per_mm()) < 1e-6; }));
  const QPoint at = logical(ultrasound().displayFromImage({4, 12}));
  const auto blueBeside = [&](ui::ViewWidget* view) {
    const QImage image = view->grab().toImage();
    const QPoint there = view->focusProxy()->mapTo(view, at);
    int blue = 0;
    for (int x = -14; x <= 14; ++x) {
      const QColor c = image.pixelColor(there.x() + x, there.y());
      blue += c.blue() > c.red() + 60;
    }
    return blue;
  };
  point(canvas_, at);
  EXPECT_TRUE(QTest::qWaitFor([&] { return blueBeside(beside()) > 8; }, 5000));
  EXPECT_LT(blueBeside(picture()), 3) << "not where the pointer itself is";
  point(beside()->focusProxy(), at);
  EXPECT_TRUE(QTest::qWaitFor([&] { return blueBeside(picture()) > 8; }, 5000));
  QEvent leave(QEvent::Leave);
  QApplication::sendEvent(beside()->focusProxy(), &leave);
  EXPECT_TRUE(QTest::qWaitFor([&] { return blueBeside(picture()) < 3; }, 5000));
}

TEST_F(TrainLayout, SaysWhatIsBeingOpenedAndNotThatNothingIsOpen) {
  auto* empty = child<QLabel>("emptyState");
  EXPECT_TRUE(empty->text().startsWith("No case is open."));
  workspace_->setOpeningText("Opening block");
  EXPECT_EQ(empty->text(), "Opening block ...");
  workspace_->setOpeningText({});
  EXPECT_TRUE(empty->text().startsWith("No case is open."));
}

TEST_F(TrainLayout, TheColumnsKeepTheirWidthWhicheverTabIsChosen) {
  for (const int width : {1400, 1024}) {
    workspace_->resize(width, 700);
    QTest::qWait(50);
    const QList<int> widths = child<QSplitter>("trainColumns")->sizes();
    child<QToolButton>("sceneTab")->click();
    QTest::qWait(50);
    EXPECT_EQ(child<QSplitter>("trainColumns")->sizes(), widths) << width;
    for (auto* button : workspace_->findChildren<QAbstractButton*>())
      if (button->accessibleName() == "Probe slice") button->click();
    QTest::qWait(50);
    EXPECT_EQ(child<QSplitter>("trainColumns")->sizes(), widths) << width;
  }
}

TEST_F(TrainLayout, NoWordIsCutWhereTheWindowIsNarrow) {
  for (const int width : {1500, 1366, 1270, 1024, 910}) {
    workspace_->resize(width, 480);
    QTest::qWait(50);
    SCOPED_TRACE(width);
    EXPECT_GT(test::expectWholeWords(workspace_.get()), 10);
  }
}

TEST_F(TrainLayout, FourSlicesAreMeasuredAndShownLikeOne) {
  openCase();
  auto* all = child<FourSlices>("fourSlices");
  key(Qt::Key_X);
  ASSERT_TRUE(QTest::qWaitFor([&] { return norm(all->slice(1).crosshair_mm()) > 1; }, kPatience_ms));
  EXPECT_TRUE(child<QToolButton>("sliceMenu")->isVisible());
  child<ui::ValueSlider>("labelOpacity")->setValue(40);
  for (std::size_t n = 0; n < FourSlices::kCount; ++n) EXPECT_NEAR(all->slice(n).labelOpacity(), 0.4, 1e-9) << n;

  key(Qt::Key_L);
  QWidget* canvas = all->widget(1).focusProxy();
  EXPECT_EQ(canvas->cursor().shape(), Qt::CrossCursor);
  const Vec3 crosshair = all->slice(1).crosshair_mm();
  const QPoint from = canvas->rect().center(), to = from + QPoint(30, 0);
  const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton what, Qt::MouseButtons held) {
    QMouseEvent event(type, at, canvas->mapToGlobal(at), what, held, Qt::NoModifier);
    QApplication::sendEvent(canvas, &event);
  };
  send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(all->slice(1).crosshair_mm(), crosshair) << "a measuring drag does not move the crosshair";
  key(Qt::Key_Delete);
  key(Qt::Key_Z);
  EXPECT_EQ(workspace_->statusText(), "Undone: removal of all measurements.");
}

TEST_F(TrainLayout, MirrorsForTheLeftHandAndRemembers) {
  auto* columns = child<QSplitter>("trainColumns");
  const auto x = [&](const QString& name) {
    return workspace_->findChild<QWidget*>(name)->mapTo(workspace_.get(), QPoint()).x();
  };
  EXPECT_LT(x("trainPanel"), x("sceneView"));
  const int panel_px = columns->sizes().first();
  action("Left-handed")->trigger();
  QTest::qWait(50);
  EXPECT_GT(x("trainPanel"), x("ultrasoundView"));
  EXPECT_LT(x("sceneView"), x("ultrasoundView"));
  EXPECT_NEAR(columns->sizes().last(), panel_px, 4) << "widths go with their columns";
  test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.resize(1100, 700);
  other.restoreLayout(settings);
  auto* same = other.findChild<QSplitter*>("trainColumns");
  EXPECT_EQ(same->widget(2)->objectName(), "trainPanel");
  action("Left-handed")->trigger();
  EXPECT_EQ(columns->widget(0)->objectName(), "trainPanel");
}

TEST_F(TrainLayout, EffectsAloneAreGoneThroughByKeysAndSaidToBeSo) {
  openCase();
  auto* effects = child<QComboBox>("effect");
  EXPECT_EQ(effects->currentText(), "all effects");
  key(Qt::Key_N);
  EXPECT_EQ(effects->currentIndex(), 1);
  EXPECT_TRUE(workspace_->statusText().contains("one effect only")) << workspace_->statusText().toStdString();
  key(Qt::Key_N, Qt::ShiftModifier);
  key(Qt::Key_N, Qt::ShiftModifier);
  EXPECT_EQ(effects->currentIndex(), effects->count() - 1);
  for (int i = 1; i < effects->count(); ++i) EXPECT_FALSE(effects->itemText(i).contains('_')) << i;
  key(Qt::Key_0);
  EXPECT_EQ(effects->currentIndex(), 0);
  EXPECT_EQ(workspace_->statusText(), "The image shows all effects again.");
}

TEST_F(TrainLayout, AllSlicesAtOnceHaveOneCrosshair) {
  openCase();
  auto* all = child<FourSlices>("fourSlices");
  const QList<int> widths = child<QSplitter>("trainColumns")->sizes();
  key(Qt::Key_X);
  ASSERT_TRUE(all->isVisible());
  EXPECT_NEAR(all->width(), picture()->width(), 24) << "as much room as the picture";
  const auto middle = [&] { return model_->motion.pose() * Vec3{0, 0, model_->imaging.settings().depth_mm / 2}; };
  const auto crosshairAt = [&](Vec3 place) {
    for (std::size_t n = 0; n < FourSlices::kCount; ++n)
      if (norm(all->slice(n).crosshair_mm() - place) > 1e-6) return false;
    return true;
  };
  EXPECT_TRUE(QTest::qWaitFor([&] { return crosshairAt(middle()); }, kPatience_ms)) << "where the probe looks";
  key(Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_TRUE(QTest::qWaitFor([&] { return crosshairAt(middle()); }, kPatience_ms)) << "and goes with it";
  const Vec3 before = all->slice(1).crosshair_mm();
  QTest::keyClick(all->widget(1).focusProxy(), Qt::Key_Up);
  EXPECT_NEAR(std::abs(all->slice(1).crosshair_mm().z - before.z), 1, 1e-6) << "the slice's own key";
  EXPECT_TRUE(crosshairAt(all->slice(1).crosshair_mm())) << "all go with the one that is moved";
  key(Qt::Key_2, Qt::AltModifier);
  for (std::size_t n = 0; n < FourSlices::kCount; ++n)
    EXPECT_EQ(all->slice(n).windowLevel(), views::windowLevelPresets()[1].value) << n;

  test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  TrainWorkspace other;
  other.restoreLayout(settings);
  EXPECT_FALSE(other.findChild<QWidget*>("fourSlices")->isHidden());
  key(Qt::Key_X);
  EXPECT_FALSE(all->isVisible());
  EXPECT_EQ(child<QSplitter>("trainColumns")->sizes(), widths) << "and back";
}

TEST_F(TrainLayout, FullSizeBringsBackNothingThatWasSwitchedOff) {
  openCase();
  for (const Qt::Key pressed : {Qt::Key_C, Qt::Key_M, Qt::Key_C}) key(pressed);
  EXPECT_FALSE(beside()->isVisible());
  EXPECT_FALSE(picture()->isMaximized());
  EXPECT_TRUE(child<QWidget>("sceneView")->isVisible());
  key(Qt::Key_M);
  key(Qt::Key_M);
  EXPECT_FALSE(beside()->isVisible());
}

TEST_F(TrainLayout, ScrollingPastAChoiceDoesNotChangeIt) {
  openCase();
  for (const char* name : {"effect", "look"}) {
    auto* choice = child<QComboBox>(name);
    const int before = choice->currentIndex();
    QWheelEvent down({5, 5}, choice->mapToGlobal(QPoint(5, 5)), {}, {0, -120}, Qt::NoButton, Qt::NoModifier,
                     Qt::NoScrollPhase, false);
    QApplication::sendEvent(choice, &down);
    EXPECT_EQ(choice->currentIndex(), before) << name;
  }
}

TEST_F(TrainLayout, EscapeMeasuresNoMore) {
  openCase();
  key(Qt::Key_L);
  EXPECT_EQ(canvas_->cursor().shape(), Qt::CrossCursor);
  key(Qt::Key_Escape);
  EXPECT_EQ(canvas_->cursor().shape(), Qt::ArrowCursor);
  key(Qt::Key_M);
  key(Qt::Key_Escape);
  EXPECT_FALSE(picture()->isMaximized()) << "without measuring, Escape means what it did";
}

TEST_F(TrainLayout, KeysInTheSliceAreTheSlices) {
  openCase();
  QWidget* canvas = mpr()->focusProxy();
  views::MprView& view = slice(mpr());
  const ProbePlacementState start = model_->motion.state();
  QTest::keyClick(canvas, Qt::Key_D);
  EXPECT_NEAR(view.labelOpacity(), 0.05, 1e-9);
  EXPECT_EQ(model_->motion.state(), start) << "and not the probe's";
  for (auto* button : workspace_->findChildren<QAbstractButton*>())
    if (button->accessibleName() == "Axial slice") button->click();
  ASSERT_EQ(view.kind(), views::SliceKind::Axial);
  QTest::qWait(300);
  const double z_mm = view.crosshair_mm().z;
  QTest::keyClick(canvas, Qt::Key_Up);
  EXPECT_NEAR(view.crosshair_mm().z, z_mm + 1, 0.6);
  EXPECT_EQ(model_->motion.state(), start);
  const double there_mm = view.crosshair_mm().z;
  QTest::qWait(300);
  EXPECT_EQ(view.crosshair_mm().z, there_mm) << "a probe at rest leaves the slice to the user";
  key(Qt::Key_2, Qt::AltModifier);
  EXPECT_EQ(view.windowLevel(), (views::WindowLevel{1000, 400}));
  EXPECT_EQ(slice(beside()).windowLevel(), view.windowLevel()) << "and beside the picture";
  key(Qt::Key_1, Qt::AltModifier);
  EXPECT_EQ(view.windowLevel(), (views::WindowLevel{350, 50}));
}

TEST_F(TrainLayout, TheSliceIsMeasuredAndMeasuresComeBack) {
  openCase();
  QWidget* canvas = mpr()->focusProxy();
  // The middle of the slice is deep in the tissue once it has followed the probe.
  ASSERT_TRUE(QTest::qWaitFor([&] { return slice(mpr()).plane().axes.up.y < -0.9; }, kPatience_ms));
  key(Qt::Key_L);
  const QPoint from = canvas->rect().center(), to = from + QPoint(60, 0);
  const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton what, Qt::MouseButtons held) {
    QMouseEvent event(type, at, canvas->mapToGlobal(at), what, held, Qt::NoModifier);
    QApplication::sendEvent(canvas, &event);
  };
  const Vec3 crosshair = slice(mpr()).crosshair_mm();
  const auto whites = [&] {
    const QImage image = mpr()->grab().toImage();
    const QPoint at = canvas->mapTo(mpr(), from);
    int white = 0;
    for (int y = -4; y <= 4; ++y) white += image.pixelColor(at.x(), at.y() + y).lightness() > 150;
    return white;
  };
  const int before = whites();
  send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
  send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  EXPECT_EQ(slice(mpr()).crosshair_mm(), crosshair) << "a measuring drag does not move the crosshair";
  EXPECT_TRUE(QTest::qWaitFor([&] { return whites() >= before + 4; }, 5000));
  key(Qt::Key_Delete);
  EXPECT_TRUE(QTest::qWaitFor([&] { return whites() <= before; }, 5000));
  key(Qt::Key_Z);
  EXPECT_EQ(workspace_->statusText(), "Undone: removal of all measurements.");
  EXPECT_TRUE(QTest::qWaitFor([&] { return whites() >= before + 4; }, 5000));
}

/// The list of positions, by keyboard.
class PositionList : public TrainWindow {
 protected:
  QStringList names() {
    QStringList all;
    auto* list = child<QListWidget>("positions");
    for (int i = 0; i < list->count(); ++i) all << list->item(i)->text().section("  ", 1);
    return all;
  }
};

TEST_F(PositionList, OwnOnesAreNamedMovedAndRemovedByKeyboardAndComeBack) {
  openCase();
  auto* list = child<QListWidget>("positions");
  for (int i = 0; i < 3; ++i) {
    key(Qt::Key_Right);
    child<QPushButton>("savePosition")->click();
  }
  EXPECT_EQ(names(), (QStringList{"over the vein", "saved position 1", "saved position 2", "saved position 3"}));
  list->setFocus();
  list->setCurrentRow(2);
  QTest::keyClick(list, Qt::Key_F2);
  auto* editor = list->findChild<QLineEdit*>();
  ASSERT_TRUE(editor);
  editor->selectAll();
  QTest::keyClicks(editor, "behind the muscle");
  QTest::keyClick(editor, Qt::Key_Return);
  ASSERT_TRUE(QTest::qWaitFor([&] { return names()[2] == "behind the muscle"; }, 2000))
      << names().join(", ").toStdString();
  QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(names(), (QStringList{"over the vein", "behind the muscle", "saved position 1", "saved position 3"}));
  EXPECT_EQ(list->currentRow(), 1);
  QTest::keyClick(list, Qt::Key_Up, Qt::AltModifier);
  EXPECT_EQ(names()[0], "over the vein") << "the case's stay in front";
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(names(), (QStringList{"over the vein", "saved position 1", "saved position 3"}));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(names()[1], "behind the muscle");
  key(Qt::Key_Z, Qt::ControlModifier);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(names(), (QStringList{"over the vein", "saved position 1", "saved position 2", "saved position 3"}));
}

TEST_F(PositionList, ThoseOfTheCaseStay) {
  openCase();
  auto* list = child<QListWidget>("positions");
  list->setCurrentRow(0);
  QTest::keyClick(list, Qt::Key_Delete);
  EXPECT_EQ(list->count(), 1);
  EXPECT_TRUE(workspace_->statusText().contains("You can change only your own positions"));
  QTest::keyClick(list, Qt::Key_F2);
  EXPECT_FALSE(list->findChild<QLineEdit*>());
}

}  // namespace
}  // namespace insonate::train
