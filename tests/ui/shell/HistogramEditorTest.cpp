#include <insonate/ui/HistogramEditor.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QSpinBox>
#include <QToolButton>
#include <QToolTip>
#include <QUndoStack>
#include <QVBoxLayout>
#include <QtTest/QTest>
#include <cmath>

namespace insonate::ui {
namespace {

using views::TransferFunction;

class HistogramEditor : public testing::Test {
 protected:
  HistogramEditor() {
    auto* box = new QVBoxLayout(&window);
    before = new QLineEdit;
    editor = new ui::HistogramEditor;
    after = new QLineEdit;
    for (QWidget* part : {static_cast<QWidget*>(before), static_cast<QWidget*>(editor), static_cast<QWidget*>(after)})
      box->addWidget(part);
    window.resize(320, 340);
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    QApplication::setActiveWindow(&window);
    plot = editor->findChild<QWidget*>("histogramPlot");
    QObject::connect(editor, &ui::HistogramEditor::functionChanged, &window, [this] { ++changes; });
  }

  /// As the plot draws it: HU even, opacity by its square root.
  QPoint at(double hu, double opacity) const {
    const auto& nodes = editor->function().nodes;
    const double least = std::min(-1024.0, nodes.front().hu), most = std::max(1600.0, nodes.back().hu);
    const double width = plot->width() - 16, height = plot->height() - 32;
    return {int(std::lround(8 + width * (hu - least) / (most - least))),
            int(std::lround(8 + height * (1 - std::sqrt(opacity))))};
  }
  QPoint node(int number) const {
    return at(editor->function().nodes[std::size_t(number)].hu, editor->function().nodes[std::size_t(number)].opacity);
  }
  /// QTest would move the screen's pointer, which ends at the screen's edge.
  void send(QEvent::Type type, QPoint place, Qt::MouseButton button, Qt::MouseButtons held) {
    QMouseEvent event(type, place, plot->mapToGlobal(place), button, held, Qt::NoModifier);
    QApplication::sendEvent(plot, &event);
  }
  void drag(QPoint from, QPoint to) {
    send(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton);
    send(QEvent::MouseMove, (from + to) / 2, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton);
    send(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton);
  }
  template <class T>
  T* child(const char* name) {
    T* found = editor->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  std::size_t count() const { return editor->function().nodes.size(); }

  QWidget window;
  QLineEdit *before = nullptr, *after = nullptr;
  ui::HistogramEditor* editor = nullptr;
  QWidget* plot = nullptr;
  int changes = 0;
};

TEST_F(HistogramEditor, ANodeIsDraggedAndADragIsOneStep) {
  const TransferFunction start = editor->function();
  QSignalSpy moving(editor, &ui::HistogramEditor::movingChanged);
  drag(node(1), at(350, 0.4));
  EXPECT_EQ(editor->selected(), 1);
  EXPECT_NEAR(editor->function().nodes[1].hu, 350, 15);
  EXPECT_NEAR(editor->function().nodes[1].opacity, 0.4, 0.03);
  EXPECT_GE(changes, 2) << "the scene follows while the hand moves";
  ASSERT_EQ(moving.count(), 2);
  EXPECT_TRUE(moving[0][0].toBool());
  EXPECT_FALSE(moving[1][0].toBool());
  EXPECT_EQ(editor->undoStack().count(), 1);
  editor->undoStack().undo();
  EXPECT_EQ(editor->function(), start);
  editor->undoStack().redo();
  EXPECT_NE(editor->function(), start);
}

TEST_F(HistogramEditor, NodesDoNotPassEachOtherNorLeaveTheField) {
  drag(node(1), at(1400, 0.2));
  EXPECT_EQ(editor->function().nodes[1].hu, 499);
  drag(node(3), QPoint(plot->width() + 200, -50));
  EXPECT_EQ(editor->function().nodes[3].opacity, 1);
  EXPECT_LE(editor->function().nodes[3].hu, TransferFunction::kMax_HU);
}

TEST_F(HistogramEditor, DoubleClickAddsANodeOfTheCurvesColor) {
  const auto expected = editor->function().colorAt(-200);
  QTest::mouseDClick(plot, Qt::LeftButton, {}, at(-200, 0.3));
  ASSERT_EQ(count(), 5u);
  EXPECT_EQ(editor->selected(), 0);
  EXPECT_NEAR(editor->function().nodes[0].hu, -200, 10);
  EXPECT_NEAR(editor->function().nodes[0].opacity, 0.3, 0.02);
  EXPECT_EQ(editor->function().nodes[0].color, expected);
}

TEST_F(HistogramEditor, DeleteAndRightClickRemoveButNotTheLast) {
  QTest::mouseClick(plot, Qt::RightButton, {}, node(2));
  EXPECT_EQ(count(), 3u);
  editor->select(0);
  plot->setFocus();
  for (int i = 0; i < 5; ++i) QTest::keyClick(plot, Qt::Key_Delete);
  EXPECT_EQ(count(), 1u);
  EXPECT_EQ(editor->function().nodes[0].hu, 1500);
  while (editor->undoStack().canUndo()) editor->undoStack().undo();
  EXPECT_EQ(count(), 4u);
}

TEST_F(HistogramEditor, TabGoesFromNodeToNodeAndOn) {
  editor->select(-1);
  child<QToolButton>("transferReset")->setFocus(Qt::OtherFocusReason);
  for (int number = 0; number < 4; ++number) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    EXPECT_TRUE(plot->hasFocus());
    EXPECT_EQ(editor->selected(), number);
  }
  QTest::keyClick(plot, Qt::Key_Tab);
  EXPECT_FALSE(plot->hasFocus()) << "the last node is not a trap";
  EXPECT_EQ(QApplication::focusWidget(), child<QSpinBox>("nodeHu"));
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Backtab);
  EXPECT_TRUE(plot->hasFocus());
  EXPECT_EQ(editor->selected(), 3);
  QTest::keyClick(plot, Qt::Key_Backtab);
  EXPECT_EQ(editor->selected(), 2);
}

TEST_F(HistogramEditor, ArrowsMoveTheNodeAndARunOfThemIsOneStep) {
  plot->setFocus();
  editor->select(1);
  for (int i = 0; i < 3; ++i) QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_EQ(editor->function().nodes[1].hu, 280);
  QTest::keyClick(plot, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_EQ(editor->function().nodes[1].hu, 279);
  QTest::keyClick(plot, Qt::Key_Up);
  EXPECT_NEAR(editor->function().nodes[1].opacity, 0.14, 1e-9);
  EXPECT_EQ(editor->undoStack().count(), 3);
  QTest::keyClick(plot, Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(plot, Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editor->function().nodes[1].hu, 280);
  EXPECT_NEAR(editor->function().nodes[1].opacity, 0.12, 1e-9);
}

TEST_F(HistogramEditor, NumbersAreTyped) {
  auto* hu = child<QSpinBox>("nodeHu");
  auto* opacity = child<QDoubleSpinBox>("nodeOpacity");
  EXPECT_FALSE(hu->isEnabled()) << "no node is chosen";
  editor->select(2);
  EXPECT_EQ(hu->value(), 500);
  EXPECT_EQ(opacity->text(), "55.0 %");
  hu->setFocus();
  hu->selectAll();
  QTest::keyClicks(hu, "620");
  QTest::keyClick(hu, Qt::Key_Return);
  EXPECT_EQ(editor->function().nodes[2].hu, 620);
  opacity->setFocus();
  opacity->selectAll();
  QTest::keyClicks(opacity, "12.5");
  QTest::keyClick(opacity, Qt::Key_Tab);
  EXPECT_NEAR(editor->function().nodes[2].opacity, 0.125, 1e-9);
  hu->selectAll();
  QTest::keyClicks(hu, "100");
  QTest::keyClick(hu, Qt::Key_Return);
  EXPECT_EQ(editor->function().nodes[2].hu, 251) << "not past its neighbour";
  EXPECT_EQ(hu->value(), 251);
  EXPECT_TRUE(QToolTip::text().startsWith("A point must stay between its neighbors: this point can be from 251 to "))
      << QToolTip::text().toStdString();
  opacity->setFocus();
  opacity->selectAll();
  QTest::keyClicks(opacity, "7,5z");
  EXPECT_TRUE(QToolTip::text().endsWith("takes a number from 0.0 % to 100.0 %.")) << QToolTip::text().toStdString();
  QTest::keyClick(opacity, Qt::Key_Return);
  EXPECT_NEAR(editor->function().nodes[2].opacity, 0.075, 1e-9) << "with a comma, as elsewhere";
}

TEST_F(HistogramEditor, PresetsResetAndTheirUndo) {
  auto* presets = child<QComboBox>("transferPreset");
  ASSERT_EQ(presets->count(), 5);
  EXPECT_EQ(presets->currentText(), "bone");
  presets->setFocus();
  QTest::keyClick(presets, Qt::Key_Down);
  editor->choosePreset("lung");
  EXPECT_EQ(presets->currentText(), "lung");
  EXPECT_EQ(editor->function(), views::transferPresets()[4].function);
  plot->setFocus();
  editor->select(0);
  QTest::keyClick(plot, Qt::Key_Right);
  EXPECT_EQ(presets->currentIndex(), -1) << "an own look has no preset's name";
  EXPECT_EQ(presets->placeholderText(), "changed");
  child<QToolButton>("transferReset")->click();
  EXPECT_EQ(editor->function(), views::transferPresets()[4].function);
  child<QToolButton>("undo")->click();
  EXPECT_EQ(presets->currentIndex(), -1);
  while (editor->undoStack().canUndo()) editor->undoStack().undo();
  EXPECT_EQ(presets->currentText(), "bone");
  editor->choosePreset("no such look");
  EXPECT_EQ(presets->currentText(), "bone");
}

TEST_F(HistogramEditor, ANodesColorIsChosen) {
  plot->setFocus();
  editor->select(1);
  QTest::keyClick(plot, Qt::Key_Return);
  auto* dialog = editor->findChild<QColorDialog*>();
  ASSERT_TRUE(dialog);
  dialog->setCurrentColor(QColor(10, 200, 30));
  dialog->accept();
  EXPECT_EQ(editor->function().nodes[1].color, (views::Color{10, 200, 30}));
  editor->undoStack().undo();
  EXPECT_EQ(editor->function().nodes[1].color, (views::Color{199, 158, 117}));
}

TEST_F(HistogramEditor, TheHistogramComesAndTheWindowIsABand) {
  const QImage bare = plot->grab().toImage();
  editor->setWindowLevel(views::WindowLevel{400, 800});
  const QImage banded = plot->grab().toImage();
  // Right of every node's curve, high: nothing but ground and band.
  const QPoint inside(plot->width() * 68 / 100, plot->height() / 4),
      outside(plot->width() * 20 / 100, plot->height() / 4);
  EXPECT_NE(banded.pixel(inside), bare.pixel(inside));
  EXPECT_EQ(banded.pixel(outside), bare.pixel(outside));
  editor->setCase(std::make_shared<const PatientCase>(test::smallCase()));
  EXPECT_TRUE(QTest::qWaitFor([&] { return plot->grab().toImage() != banded; }, 20000));
  editor->setCase(nullptr);
  EXPECT_TRUE(QTest::qWaitFor([&] { return plot->grab().toImage() == banded; }, 20000));
}

TEST_F(HistogramEditor, GoesWhileItCounts) {
  for (int i = 0; i < 3; ++i) {
    ui::HistogramEditor other;
    auto large = std::make_shared<PatientCase>(test::smallCase());
    large->ct.voxels.resize(20'000'000);
    other.setCase(large);
    other.setCase(nullptr);
    other.setCase(large);
  }
}

}  // namespace
}  // namespace insonate::ui
