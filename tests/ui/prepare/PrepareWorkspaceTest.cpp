#include "PrepareWindow.h"

#include <insonate/views/UltrasoundView.h>

#include <ui/support/WholeWords.h>

#include <QTabBar>

namespace insonate::prepare {
namespace {

TEST_F(PrepareWindow, WithoutACaseItSaysWhatToDo) {
  QAction open("Open case ...", nullptr);
  workspace_->addOpenAction(&open);
  bool asked = false;
  QObject::connect(&open, &QAction::triggered, [&] { asked = true; });
  auto* button = child<QWidget>("prepareEmpty")->findChild<QPushButton*>();
  ASSERT_TRUE(button);
  ASSERT_TRUE(QTest::qWaitFor([&] { return button->isVisible(); }));
  button->click();
  EXPECT_TRUE(asked);
  EXPECT_FALSE(workspace_->isReady());
  EXPECT_FALSE(child<QTableView>("structures")->isVisible());
  openCase();
  EXPECT_FALSE(button->isVisible());
  EXPECT_TRUE(table()->isVisible());
  workspace_->setCase(nullptr);
  EXPECT_TRUE(button->isVisible());
}

TEST_F(PrepareWindow, FactsAndVolumesAreShown) {
  workspace_->setOrigin({"/cases/block", {"The gantry was tilted by 5 degrees and is straight now."}, false});
  openCase();
  EXPECT_EQ(child<QLabel>("caseSize")->text(), "49 x 41 x 17");
  EXPECT_EQ(child<QLabel>("caseRange")->text(), "-1000 to 900 HU");
  EXPECT_EQ(child<QLabel>("caseFolder")->text(), "block");
  EXPECT_TRUE(child<QLabel>("caseNotes")->text().contains("gantry"));
  ASSERT_EQ(table()->model()->rowCount(), 4);
  const double ml = double(std::ranges::count(patient()->labels.voxels, kVein)) / 1000;
  const auto index = table()->model()->index(rowOf(kVein), kVolume);
  EXPECT_NEAR(index.data().toString().toDouble(), ml, 0.01);
  EXPECT_EQ(table()->model()->index(rowOf(kVein), kName).data().toString(), "vein");
}

TEST_F(PrepareWindow, WhatTheImportSaidStaysWithTheCase) {
  PatientCase imported = *patient();
  imported.manifest.importNotes = {"The slices were tilted.", "Padding was named."};
  workspace_->setOrigin({{}, {"The slices were tilted."}, false});
  workspace_->setCase(std::make_shared<const PatientCase>(imported));
  EXPECT_EQ(child<QLabel>("caseNotes")->text(), "The slices were tilted.\nPadding was named.") << "each once";
}

TEST_F(PrepareWindow, WhatHappenedIsSaidForSomeSeconds) {
  const QString before = workspace_->statusText();
  EXPECT_FALSE(before.isEmpty());
  shared_->notice.showMessage("Something happened.");
  EXPECT_EQ(workspace_->statusText(), "Something happened.");
  EXPECT_TRUE(QTest::qWaitFor([&] { return workspace_->statusText() == before; }, Notice::kShown_ms + 3000))
      << workspace_->statusText().toStdString();
}

TEST_F(PrepareWindow, OneCrosshairForAllSlices) {
  openCase();
  shared_->crosshair.moveTo({3, 10, -2});
  EXPECT_EQ(axial().crosshair_mm(), (Vec3{3, 10, -2}));
  EXPECT_TRUE(workspace_->statusText().contains("vein")) << workspace_->statusText().toStdString();
  key(Qt::Key_Up);
  EXPECT_NEAR(shared_->crosshair.position_mm().z, -1, 1e-6);
  QTest::keyClick(canvas("Coronal slice"), Qt::Key_Up);
  EXPECT_NEAR(shared_->crosshair.position_mm().y, 11, 1e-6);
  EXPECT_EQ(axial().crosshair_mm(), shared_->crosshair.position_mm());
  shared_->crosshair.moveTo({1000, 0, 0});
  EXPECT_NEAR(shared_->crosshair.position_mm().x, 24.5, 1e-6) << "within the volume";
}

TEST_F(PrepareWindow, AfterAJumpTheFormerImageIsMarkedAtOnce) {
  openCase();
  const auto& view = static_cast<const views::UltrasoundView&>(child<ui::ViewWidget>("labelUltrasound")->view());
  EXPECT_EQ(view.staleMark(), "");
  shared_->live.goTo({"aside", {-20, 0, 0}, {0, 1, 0}, {1, 0, 0}});
  EXPECT_EQ(view.staleMark(), "Image of the previous position");
  EXPECT_TRUE(QTest::qWaitFor([&] { return view.staleMark().empty(); }, kPatience_ms));
  EXPECT_EQ(shared_->live.shown()->patientFromProbe, *shared_->live.pose());
}

TEST_F(PrepareWindow, WindowAndLevelByPresetNumberAndDrag) {
  openCase();
  auto* preset = child<QComboBox>("windowPreset");
  EXPECT_EQ(preset->count(), 6);
  preset->setCurrentIndex(1);
  Q_EMIT preset->activated(1);
  EXPECT_EQ(shared_->slices.windowLevel(), (views::WindowLevel{1000, 400}));
  EXPECT_EQ(axial().windowLevel(), (views::WindowLevel{1000, 400}));
  EXPECT_EQ(child<ui::ValueSlider>("window")->value(), 1000);
  child<ui::ValueSlider>("level")->setValue(300);
  EXPECT_EQ(axial().windowLevel(), (views::WindowLevel{1000, 300}));
  EXPECT_EQ(preset->currentIndex(), 5) << "the user's own";
  QWidget* slice = canvas("Axial slice");
  const QPoint from = slice->rect().center(), to = from + QPoint(30, 0);
  const auto send = [&](QEvent::Type type, QPoint at, Qt::MouseButton what, Qt::MouseButtons held) {
    QMouseEvent event(type, at, slice->mapToGlobal(at), what, held, Qt::NoModifier);
    QApplication::sendEvent(slice, &event);
  };
  send(QEvent::MouseButtonPress, from, Qt::RightButton, Qt::RightButton);
  send(QEvent::MouseMove, to, Qt::NoButton, Qt::RightButton);
  send(QEvent::MouseButtonRelease, to, Qt::RightButton, Qt::NoButton);
  EXPECT_GT(shared_->slices.windowLevel().window_HU, 1000);
  EXPECT_EQ(child<ui::ValueSlider>("window")->value(), std::round(shared_->slices.windowLevel().window_HU));
}

TEST_F(PrepareWindow, LabelKeysWorkInEverySlice) {
  openCase();
  key(Qt::Key_D);
  EXPECT_NEAR(shared_->slices.labelOpacity(), 0.3, 1e-9);
  EXPECT_NEAR(axial().labelOpacity(), 0.3, 1e-9);
  QTest::keyClick(canvas("Sagittal slice"), Qt::Key_A);
  QTest::keyClick(canvas("Scene"), Qt::Key_A);
  EXPECT_NEAR(axial().labelOpacity(), 0.2, 1e-9);
  key(Qt::Key_G);
  EXPECT_FALSE(shared_->slices.labelsShown());
  EXPECT_FALSE(child<QCheckBox>("labelsShown")->isChecked());
  child<QCheckBox>("labelsShown")->click();
  EXPECT_TRUE(shared_->slices.labelsShown());
  child<ui::ValueSlider>("labelOpacity")->setValue(80);
  EXPECT_NEAR(axial().labelOpacity(), 0.8, 1e-9);
  key(Qt::Key_W);
  EXPECT_EQ(shared_->structures.selected(), shared_->structures.labels()[1]);
  QTest::keyClick(table(), Qt::Key_Q);
  EXPECT_EQ(shared_->structures.selected(), shared_->structures.labels()[0]) << "also where the table has the keyboard";
}

TEST_F(PrepareWindow, EachCommandIsListedAndWaitsForACase) {
  const auto isAvailable = [this](int key) {
    return workspace_->commands().key(QKeyEvent(QEvent::KeyPress, key, Qt::NoModifier), false);
  };
  for (const ui::Command& one : workspace_->commands().all()) {
    SCOPED_TRACE(one.id.toStdString());
    EXPECT_TRUE(one.id.startsWith("prepare."));
    EXPECT_FALSE(one.listed.isEmpty() || one.does.isEmpty());
    for (const ui::CommandKey& key : one.keys) EXPECT_FALSE(isAvailable(key.key)) << "there is no case";
  }
  for (const ui::ShortcutGroup& section : workspace_->commands().shortcuts()) EXPECT_FALSE(section.place.isEmpty());
  openCase();
  for (const int key :
       {Qt::Key_Q,           Qt::Key_W, Qt::Key_H,    Qt::Key_L,     Qt::Key_S,    Qt::Key_A,     Qt::Key_D,
        Qt::Key_G,           Qt::Key_C, Qt::Key_Home, Qt::Key_Space, Qt::Key_Plus, Qt::Key_Minus, Qt::Key_BracketRight,
        Qt::Key_BracketLeft, Qt::Key_1, Qt::Key_2,    Qt::Key_3,     Qt::Key_4,    Qt::Key_5,     Qt::Key_6,
        Qt::Key_7,           Qt::Key_8, Qt::Key_9,    Qt::Key_0})
    EXPECT_TRUE(isAvailable(key)) << key;
  const auto ofTool = {Qt::Key_Return, Qt::Key_Enter, Qt::Key_Escape};
  for (const int key : ofTool) EXPECT_FALSE(isAvailable(key)) << "without a tool, the key is the window's";
  key(Qt::Key_3);
  for (const int key : ofTool) EXPECT_TRUE(isAvailable(key)) << key;
  EXPECT_FALSE(isAvailable(Qt::Key_Delete)) << "no click yet";
}

TEST_F(PrepareWindow, CLeadsToTheCheckAndBack) {
  openCase();
  auto* pages = child<QTabBar>("rightPages");
  child<QToolButton>("section-check")->click();
  key(Qt::Key_C);
  EXPECT_EQ(pages->currentIndex(), 1);
  EXPECT_TRUE(child<QToolButton>("section-check")->isChecked()) << "the findings are unfolded";
  EXPECT_TRUE(pages->tabToolTip(0).endsWith("(C)"));
  EXPECT_TRUE(child<QPushButton>("toStart")->toolTip().endsWith("(Home)"));
  key(Qt::Key_C);
  EXPECT_EQ(pages->currentIndex(), 0);
}

TEST_F(PrepareWindow, AFindingBringsTheCrosshairToItsPlace) {
  auto wrong = std::make_shared<PatientCase>(*patient());
  wrong->manifest.targets = {{"vein", kVein, {10, 20, 3}}};
  openCase(wrong);
  auto* button = child<QPushButton>("place-target_label");
  button->click();
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{10, 20, 3}));
  child<QPushButton>("toFindings")->click();
  auto* fold = child<QToolButton>("section-check");
  EXPECT_TRUE(fold->isChecked());
  fold->click();
  EXPECT_FALSE(button->isVisible());
}

TEST_F(PrepareWindow, TheUltrasoundFollowsTheCrosshair) {
  openCase();
  const auto first = shared_->live.shown();
  ASSERT_TRUE(first);
  EXPECT_GT(std::ranges::max(first->image.gray), 40) << "something is seen";
  shared_->crosshair.moveTo({12, 15, 0});
  const auto atRest = [&] { return shared_->live.isSettled() && shared_->live.shown()->press.settled; };
  ASSERT_TRUE(QTest::qWaitFor(atRest, kPatience_ms));
  const Vec3 probe_mm = shared_->live.shown()->patientFromProbe.offset;
  EXPECT_NEAR(probe_mm.x, 12, 1.5);
  EXPECT_NEAR(probe_mm.y, 0, 1.5) << "on the skin";
  const auto number = shared_->live.shown()->number;
  QTest::qWait(300);
  EXPECT_EQ(shared_->live.shown()->number, number) << "held still, it costs nothing";
  key(Qt::Key_Home);
  EXPECT_EQ(shared_->crosshair.position_mm(), (Vec3{0, 0, 0}));
}

TEST_F(PrepareWindow, HiddenItMakesNoPictures) {
  openCase();
  workspace_->hide();
  const auto last = shared_->live.shown();
  shared_->crosshair.moveTo({5, 15, 0});
  QTest::qWait(300);
  EXPECT_EQ(shared_->live.shown(), last);
  workspace_->show();
  EXPECT_TRUE(QTest::qWaitFor([&] { return shared_->live.shown() != last; }, kPatience_ms));
}

TEST_F(PrepareWindow, AViewFillsTheMiddleAndComesBack) {
  openCase();
  auto* coronal = child<ui::ViewWidget>("Coronal slice");
  QTest::mouseDClick(coronal->focusProxy(), Qt::LeftButton);
  EXPECT_TRUE(coronal->isMaximized());
  EXPECT_FALSE(child<ui::ViewWidget>("Scene")->isVisible());
  EXPECT_TRUE(table()->isVisible()) << "controls stay";
  QTest::keyClick(coronal->focusProxy(), Qt::Key_Escape);
  EXPECT_TRUE(child<ui::ViewWidget>("Scene")->isVisible());
}

TEST_F(PrepareWindow, NothingIsWiderThanItsColumn) {
  workspace_->resize(1366, 700);
  openCase();
  child<QCheckBox>("ctVolume")->click();
  for (auto* heading : workspace_->findChildren<QToolButton*>())
    if (heading->objectName().startsWith("section-") && !heading->isChecked()) heading->click();
  QTest::qWait(300);
  for (auto* scroll : workspace_->findChildren<QScrollArea*>())
    EXPECT_LE(scroll->widget()->minimumSizeHint().width(), scroll->viewport()->width());
}

TEST_F(PrepareWindow, EveryControlHasANameAndATip) {
  openCase();
  for (auto* widget : workspace_->findChildren<QWidget*>()) {
    const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QComboBox*>(widget) ||
                         qobject_cast<QLineEdit*>(widget) || qobject_cast<QTableView*>(widget);
    if (!control || !widget->isVisible() || widget->objectName().startsWith("qt_")) continue;
    auto* button = qobject_cast<QAbstractButton*>(widget);
    EXPECT_TRUE(!widget->accessibleName().isEmpty() || (button && !button->text().isEmpty()))
        << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    const bool tip =
        !widget->toolTip().isEmpty() || (widget->parentWidget() && !widget->parentWidget()->toolTip().isEmpty());
    EXPECT_TRUE(tip || qobject_cast<QTableView*>(widget) ||
                widget->metaObject()->className() == std::string("QTableCornerButton"))
        << widget->metaObject()->className() << " " << widget->objectName().toStdString() << " "
        << (button ? button->text().toStdString() : "");
  }
}

TEST_F(PrepareWindow, ACaseWithoutABodySaysSo) {
  auto empty = std::make_shared<PatientCase>(*patient());
  std::ranges::fill(empty->labels.voxels, kBackground);
  openCase(empty);
  EXPECT_EQ(table()->model()->rowCount(), 0);
  EXPECT_FALSE(child<QLabel>("ultrasoundState")->text().isEmpty());
  EXPECT_FALSE(child<QPushButton>("showOnly")->isEnabled());
  key(Qt::Key_W), key(Qt::Key_H), key(Qt::Key_Home);
  QTest::keyClick(table(), Qt::Key_Return);
}

TEST_F(PrepareWindow, TheBlackAreaNamesWhatIsComputedUntilThereIsAnImage) {
  const auto notice = [this] {
    return static_cast<views::UltrasoundView&>(child<ui::ViewWidget>("labelUltrasound")->view()).notice();
  };
  std::string named;
  const auto listening =
      QObject::connect(&shared_->live, &LivePatient::stateChanged, workspace_.get(), [&] { named += notice(); });
  workspace_->setCase(patient());
  EXPECT_TRUE(shared_->live.isBuilding());
  EXPECT_NE(notice().find("Finding the skin"), std::string::npos) << notice();
  ASSERT_TRUE(QTest::qWaitFor([&] { return shared_->live.shown() != nullptr; }, kPatience_ms));
  QObject::disconnect(listening);
  EXPECT_NE(named.find("Building the scene"), std::string::npos) << named;
  EXPECT_TRUE(QTest::qWaitFor([&] { return notice().empty(); }, kPatience_ms)) << notice();
  EXPECT_FALSE(shared_->live.isBuilding());
}

/// The library and the levels open the published version, which an author can neither edit nor publish.
TEST_F(PrepareWindow, FromAVersionAButtonLeadsToTheCurrentCase) {
  openCase();
  EXPECT_FALSE(child<QWidget>("versionBanner")->isVisible());
  ui::CaseOrigin version;
  version.versionOf = QStringLiteral("/somewhere/neck");
  version.readFrom = QStringLiteral("/somewhere/neck/versions/002");
  workspace_->setOrigin(version);
  openCase();
  EXPECT_TRUE(child<QWidget>("versionBanner")->isVisible());
  QString asked;
  QObject::connect(workspace_.get(), &ui::Workspace::caseRequested, [&](const QString& place) { asked = place; });
  QTest::mouseClick(child<QPushButton>("openCurrent"), Qt::LeftButton);
  EXPECT_EQ(asked, version.versionOf);
  ui::CaseOrigin downloaded;
  downloaded.versionOf = downloaded.readFrom = QStringLiteral("/somewhere/downloads/neck");
  workspace_->setOrigin(downloaded);
  EXPECT_FALSE(child<QWidget>("versionBanner")->isVisible()) << "its current state is on the server";
}

TEST_F(PrepareWindow, GoesAtAnyMoment) {
  for (const int wait_ms : {0, 1, 20, 60, 150}) {
    ui::TaskBar tasks;
    auto workspace = std::make_unique<PrepareWorkspace>(tasks);
    workspace->show();
    workspace->setCase(patient());
    if (wait_ms > 0) QTest::qWait(wait_ms);
    if (wait_ms == 20) workspace->setCase(patient());
    workspace->stop();
    workspace.reset();
    QTest::qWait(20);
  }
}

TEST_F(PrepareWindow, NoWordIsCut) {
  openCase();
  for (const int width : {1600, 1440, 1366, 1270, 1100}) {
    SCOPED_TRACE(width);
    workspace_->resize(width, 760);
    QTest::qWait(50);
    EXPECT_GT(test::expectWholeWords(workspace_.get()), 10);
  }
}

TEST_F(PrepareWindow, ThePaletteHasWholeNamesOrNone) {
  openCase();
  auto* palette = child<QWidget>("toolBar");
  const auto names = [&] { return child<QToolButton>("tool-threshold")->toolButtonStyle(); };
  const auto isWhole = [](const QToolButton* button) { return button->width() >= button->sizeHint().width(); };
  workspace_->resize(1600, 760);
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return names() == Qt::ToolButtonTextUnderIcon &&
               std::ranges::all_of(palette->findChildren<QToolButton*>(), isWhole);
      },
      kPatience_ms));
  workspace_->resize(1000, 760);
  ASSERT_TRUE(QTest::qWaitFor([&] { return names() == Qt::ToolButtonIconOnly; }, kPatience_ms));
  EXPECT_FALSE(child<QToolButton>("tool-threshold")->toolTip().isEmpty());
}

}  // namespace
}  // namespace insonate::prepare
