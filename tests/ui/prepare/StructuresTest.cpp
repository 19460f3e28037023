#include "PrepareWindow.h"

namespace insonate::prepare {
namespace {

TEST_F(PrepareWindow, TheEyeHidesInThreeDimensionsAndOnSlices) {
  openCase();
  EXPECT_TRUE(scene().isVisible(kVein));
  clickCell(kVein, kEye);
  EXPECT_FALSE(scene().isVisible(kVein));
  EXPECT_FALSE(shared_->appearance.look(kVein).visible);
  EXPECT_EQ(shared_->structures.selected(), kVein);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(scene().isVisible(kVein));
  key(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_FALSE(scene().isVisible(kVein));
  QTest::keyClick(table(), Qt::Key_Space);
  EXPECT_TRUE(shared_->appearance.look(kVein).visible);
  key(Qt::Key_H);
  EXPECT_FALSE(shared_->appearance.look(kVein).visible);
  EXPECT_FALSE(workspace_->unsavedEdit()) << "what is seen is not the case's";
}

TEST_F(PrepareWindow, OnlyThisAndShowAllAreOneStepEach) {
  openCase();
  shared_->structures.select(kBone);
  child<QPushButton>("showOnly")->click();
  EXPECT_TRUE(shared_->appearance.look(kBone).visible);
  EXPECT_FALSE(shared_->appearance.look(kVein).visible);
  EXPECT_FALSE(shared_->appearance.look(kSkin).visible);
  child<QPushButton>("showAll")->click();
  EXPECT_TRUE(shared_->appearance.look(kVein).visible);
  child<QAction>("undo")->trigger();
  child<QAction>("undo")->trigger();
  EXPECT_TRUE(shared_->appearance.look(kSkin).visible);
  EXPECT_FALSE(shared_->openCase.undoStack().canUndo());
}

TEST_F(PrepareWindow, AColorIsChosenInADialogAndBelongsToTheCase) {
  openCase();
  bool told = false;
  QObject::connect(workspace_.get(), &ui::Workspace::editsChanged, [&] { told = true; });
  clickCell(kVein, kColor);
  auto* dialog = child<QColorDialog>("structureColour");
  dialog->setCurrentColor(QColor(10, 200, 30));
  dialog->accept();
  EXPECT_EQ(shared_->appearance.look(kVein).color, (views::Color{10, 200, 30}));
  EXPECT_EQ(scene().color(kVein), (views::Color{10, 200, 30}));
  EXPECT_TRUE(told);
  const ui::CaseEdit edit = workspace_->unsavedEdit();
  ASSERT_TRUE(edit);
  PatientCase copy = *patient();
  edit(copy);
  EXPECT_EQ(copy.colors, (LabelColors{{kVein, {10, 200, 30}}}));
  child<QAction>("undo")->trigger();
  EXPECT_FALSE(workspace_->unsavedEdit()) << "taken back is as never done";
  EXPECT_EQ(scene().color(kVein), views::Color({0, 151, 206}));
}

TEST_F(PrepareWindow, ACaseBringsItsColors) {
  auto own = std::make_shared<PatientCase>(*patient());
  own->colors = {{kVein, {1, 2, 3}}};
  openCase(own);
  EXPECT_EQ(scene().color(kVein), (views::Color{1, 2, 3}));
  EXPECT_FALSE(workspace_->unsavedEdit());
  shared_->appearance.setColor(kVein, {0, 151, 206});
  PatientCase copy = *own;
  workspace_->unsavedEdit()(copy);
  EXPECT_TRUE(copy.colors.empty()) << "the label table's need no place in the case";
}

TEST_F(PrepareWindow, OpacityOfADragIsOneStep) {
  openCase();
  shared_->structures.select(kBone);
  auto* slider = child<ui::ValueSlider>("structureOpacity");
  EXPECT_EQ(slider->value(), 100);
  for (const double percent : {90.0, 60.0, 40.0}) slider->setValue(percent);
  EXPECT_DOUBLE_EQ(scene().opacity(kBone), 0.4);
  EXPECT_EQ(shared_->openCase.undoStack().count(), 1);
  child<QAction>("undo")->trigger();
  EXPECT_EQ(slider->value(), 100);
  child<QAction>("redo")->trigger();
  EXPECT_EQ(slider->value(), 40) << "the end of the drag";
  shared_->structures.select(kVein);
  EXPECT_EQ(slider->value(), 100);
}

/// In the label table their colors are neighbours.
TEST_F(PrepareWindow, AnArteryIsToldFromTheMuscleAroundItOnEveryGray) {
  openCase();
  const auto over = [&](std::uint8_t label, double gray) {
    const StructureLook& look = shared_->appearance.look(label);
    const double share = shared_->slices.labelOpacity() * look.onSlices;
    const auto mixed = [&](std::uint8_t part) { return (1 - share) * gray + share * part; };
    return Vec3{mixed(look.color.red), mixed(look.color.green), mixed(look.color.blue)};
  };
  for (const double gray : {0.0, 60.0, 128.0, 255.0})
    for (const std::uint8_t other : {kMuscle, kFat, kSoftTissue})
      EXPECT_GT(norm(over(kArtery, gray) - over(other, gray)), 15) << gray << ", " << int(other);
}

TEST_F(PrepareWindow, ASurfaceIsMadeWhenItBeginsToBeSeen) {
  openCase();
  const auto has = [&](std::uint8_t label) {
    const auto all = scene().structures();
    return std::ranges::find(all, label) != all.end();
  };
  EXPECT_TRUE(has(kVein));
  EXPECT_FALSE(has(kSoftTissue)) << "it fills the body and would hide everything";
  shared_->appearance.setOpacity(kSoftTissue, 0.3);
  EXPECT_TRUE(QTest::qWaitFor([&] { return has(kSoftTissue); }, kPatience_ms));
}

/// Some users cannot tell the colors of states apart.
TEST_F(PrepareWindow, EachStateHasASignOfItsOwnShape) {
  openCase();
  const auto shapeIn = [&](int column) {
    const auto icon = table()->model()->index(rowOf(kVein), column).data(Qt::DecorationRole).value<QIcon>();
    return icon.pixmap(40, 40).toImage().convertToFormat(QImage::Format_Alpha8);
  };
  const auto differ = [](const std::vector<QImage>& shapes) {
    for (std::size_t n = 1; n < shapes.size(); ++n)
      if (std::find(shapes.begin(), shapes.begin() + std::ptrdiff_t(n), shapes[n]) !=
          shapes.begin() + std::ptrdiff_t(n))
        return false;
    return true;
  };
  std::vector<QImage> eyes{shapeIn(kEye)};
  shared_->appearance.setOpacity(kVein, 0);
  eyes.push_back(shapeIn(kEye));
  shared_->appearance.setVisible(kVein, false);
  eyes.push_back(shapeIn(kEye));
  EXPECT_TRUE(differ(eyes)) << "shown, transparent, hidden";
  std::vector<QImage> progress;
  for (const LabelState state : kLabelStates) {
    shared_->terms.setState(kVein, state);
    progress.push_back(shapeIn(kState));
  }
  EXPECT_TRUE(differ(progress));
}

TEST_F(PrepareWindow, TheTitleCanBeChangedAndTakenBack) {
  openCase();
  auto* title = child<QLineEdit>("caseTitle");
  title->setText("  Another   name ");
  Q_EMIT title->editingFinished();
  EXPECT_EQ(shared_->openCase.title(), "Another name");
  PatientCase copy = *patient();
  workspace_->unsavedEdit()(copy);
  EXPECT_EQ(copy.manifest.title, "Another name");
  title->setText("");
  Q_EMIT title->editingFinished();
  EXPECT_EQ(title->text(), "Another name") << "a case has a title";
  child<QAction>("undo")->trigger();
  EXPECT_EQ(title->text(), "Small block");
  EXPECT_FALSE(workspace_->unsavedEdit());
}

TEST_F(PrepareWindow, RemembersHowOneLooks) {
  openCase();
  shared_->appearance.setVisible(kBone, false);
  shared_->appearance.setOpacity(kVein, 0.5);
  shared_->slices.setWindowLevel({1500, -600});
  child<QToolButton>("section-slices")->click();
  test::TemporaryFolder folder;
  QSettings settings(QString::fromStdString((folder / "layout.ini").string()), QSettings::IniFormat);
  workspace_->saveLayout(settings);
  ui::TaskBar tasks;
  PrepareWorkspace other(tasks);
  other.restoreLayout(settings);
  other.setCase(patient());
  const PrepareModel shared = modelOf(other);
  EXPECT_FALSE(shared.appearance.look(kBone).visible);
  EXPECT_DOUBLE_EQ(shared.appearance.look(kVein).opacity, 0.5);
  EXPECT_EQ(shared.slices.windowLevel(), (views::WindowLevel{1500, -600}));
  EXPECT_FALSE(other.findChild<QToolButton*>("section-slices")->isChecked());
}

}  // namespace
}  // namespace insonate::prepare
