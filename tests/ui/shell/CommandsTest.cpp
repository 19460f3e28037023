#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/Commands.h>

#include <gtest/gtest.h>

#include <QAction>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPushButton>
#include <QWidget>
#include <memory>
#include <string>

namespace insonate::ui {
namespace {

QKeyEvent pressed(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, bool isRepeated = false) {
  return QKeyEvent(QEvent::KeyPress, key, modifiers, {}, isRepeated);
}

class CommandsTest : public testing::Test {
 protected:
  CommandsTest() {
    commands.beginSection("Probe");
    commands.add({.id = "test.probe.slide",
                  .text = {},
                  .does = "slides the probe by 1 mm (with Shift: 5 mm)",
                  .listed = "Left, Right",
                  .keys = {{Qt::Key_Left, {}, [this](KeyPress press) { at_mm -= press.wide ? 5 : 1; }},
                           {Qt::Key_Right, {}, [this](KeyPress press) { at_mm += press.wide ? 5 : 1; }}},
                  .perform = {}});
    commands.beginSection("Image");
    commands.add({.id = "test.image.save",
                  .text = "Save image",
                  .does = "saves the image",
                  .listed = "Ctrl+P",
                  .keys = {{Qt::Key_P, Qt::ControlModifier, {}}},
                  .perform = [this](KeyPress) { ++saved; },
                  .isAvailable = [this] { return isImageThere; }});
  }

  Commands commands;
  int at_mm = 0, saved = 0;
  bool isImageThere = true;
};

TEST_F(CommandsTest, AKeyPerformsItsCommand) {
  EXPECT_TRUE(commands.key(pressed(Qt::Key_Right), true));
  EXPECT_TRUE(commands.key(pressed(Qt::Key_Left, Qt::ShiftModifier), true)) << "Shift takes the wide step";
  EXPECT_EQ(at_mm, -4);
  EXPECT_TRUE(commands.key(pressed(Qt::Key_Right), false));
  EXPECT_EQ(at_mm, -4) << "asked only";
}

TEST_F(CommandsTest, ControlMakesAnotherKey) {
  EXPECT_FALSE(commands.key(pressed(Qt::Key_P), true));
  EXPECT_FALSE(commands.key(pressed(Qt::Key_Left, Qt::AltModifier), true));
  EXPECT_TRUE(commands.key(pressed(Qt::Key_P, Qt::ControlModifier), true));
  EXPECT_EQ(saved, 1);
}

TEST_F(CommandsTest, AnUnavailableCommandLeavesTheKeyToOthers) {
  isImageThere = false;
  EXPECT_FALSE(commands.key(pressed(Qt::Key_P, Qt::ControlModifier), true));
  commands.action("test.image.save")->trigger();
  EXPECT_EQ(saved, 0);
}

TEST_F(CommandsTest, AShortcutOverrideIsAcceptedAndNotPerformed) {
  QKeyEvent asked(QEvent::ShortcutOverride, Qt::Key_P, Qt::ControlModifier);
  asked.ignore();
  EXPECT_TRUE(commands.handleKeyEvent(asked));
  EXPECT_TRUE(asked.isAccepted());
  EXPECT_EQ(saved, 0);
  QKeyEvent other(QEvent::ShortcutOverride, Qt::Key_O, Qt::ControlModifier);
  EXPECT_FALSE(commands.handleKeyEvent(other)) << "stays with the window's shortcuts";
}

TEST_F(CommandsTest, MenuTooltipAndListSayTheSame) {
  QAction* action = commands.action("test.image.save");
  ASSERT_TRUE(action);
  EXPECT_EQ(action, commands.action("test.image.save"));
  EXPECT_EQ(action->text().toStdString(), "Save image\tCtrl+P");
  EXPECT_EQ(action->toolTip().toStdString(), "Saves the image (Ctrl+P)");
  action->trigger();
  EXPECT_EQ(saved, 1);
  EXPECT_FALSE(commands.action("test.image.other"));
  EXPECT_EQ(commands.toolTip("test.image.other").toStdString(), "");
}

TEST_F(CommandsTest, AnActionHandlesItsKeyAndIsListed) {
  QAction open("Open ...");
  open.setShortcut(QKeySequence("Ctrl+O"));
  commands.add("test.case.open", "opens a case", open);
  EXPECT_EQ(open.toolTip().toStdString(), "Opens a case (Ctrl+O)");
  EXPECT_EQ(commands.action("test.case.open"), &open);
  EXPECT_EQ(commands.shortcuts().back().shortcuts.back().keys.toStdString(), "Ctrl+O");
  EXPECT_FALSE(commands.key(pressed(Qt::Key_O, Qt::ControlModifier), true)) << "Qt handles the key";
  int opened = 0;
  QObject::connect(&open, &QAction::triggered, &open, [&opened] { ++opened; });
  commands.find("test.case.open")->perform({});
  EXPECT_EQ(opened, 1);
  open.setEnabled(false);
  EXPECT_FALSE(commands.find("test.case.open")->isAvailable());
}

TEST_F(CommandsTest, AButtonGetsItsKeyAndTooltip) {
  QPushButton refresh("Refresh");
  commands.add("test.class.refresh", "reads the class again", refresh, QKeySequence(Qt::Key_F5));
  EXPECT_EQ(refresh.shortcut(), QKeySequence(Qt::Key_F5));
  EXPECT_EQ(refresh.toolTip().toStdString(), "Reads the class again (F5)");
  EXPECT_EQ(commands.toolTip("Saves this page", "test.class.refresh").toStdString(), "Saves this page (F5)");
  EXPECT_EQ(commands.toolTip("Saves this page", "test.class.other").toStdString(), "Saves this page");
}

TEST_F(CommandsTest, TheListIsBySectionInTheOrderOfAdding) {
  commands.beginSection("Empty");
  commands.beginSection("Probe");
  commands.addListed("Left drag", "slides the probe");
  const auto sections = commands.shortcuts();
  ASSERT_EQ(sections.size(), 2U);
  EXPECT_EQ(sections[0].place.toStdString(), "Probe");
  ASSERT_EQ(sections[0].shortcuts.size(), 2U);
  EXPECT_EQ(sections[0].shortcuts[1].keys.toStdString(), "Left drag");
  EXPECT_EQ(sections[1].shortcuts[0].does.toStdString(), "saves the image");
}

/// Notes its name for each mouse press.
class Noting : public QObject {
 public:
  Noting(std::string name, std::string& order, bool isConsuming = false)
      : name_(std::move(name)), order_(order), isConsuming_(isConsuming) {}
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::MouseButtonPress) return false;
    order_ += name_ + ' ';
    return isConsuming_;
  }

 private:
  std::string name_;
  std::string& order_;
  bool isConsuming_;
};

void press(QWidget& canvas) {
  QMouseEvent event(QEvent::MouseButtonPress, {1, 1}, Qt::LeftButton, Qt::LeftButton, {});
  QCoreApplication::sendEvent(&canvas, &event);
}

TEST(CanvasInput, TheRankDecidesNotTheOrderOfAdding) {
  std::string order;
  QWidget canvas;
  Noting pointer("pointer", order), observer("observer", order), guide("guide", order);
  CanvasInput& input = CanvasInput::of(canvas);
  EXPECT_EQ(&input, &CanvasInput::of(canvas));
  input.add(InputRank::Pointer, pointer);
  input.add(InputRank::Observer, observer);
  input.add(InputRank::Guide, guide);
  input.add(InputRank::Guide, guide);
  press(canvas);
  EXPECT_EQ(order, "observer guide pointer ");
  order.clear();
  input.remove(guide);
  press(canvas);
  EXPECT_EQ(order, "observer pointer ");
}

TEST(CanvasInput, TheFirstThatConsumesAnEventEndsIt) {
  std::string order;
  QWidget canvas;
  Noting pointer("pointer", order), guide("guide", order, true);
  auto tool = std::make_unique<Noting>("tool", order, true);
  CanvasInput::of(canvas).add(InputRank::Pointer, pointer);
  CanvasInput::of(canvas).add(InputRank::Guide, guide);
  CanvasInput::of(canvas).add(InputRank::Tool, *tool);
  press(canvas);
  EXPECT_EQ(order, "tool ");
  order.clear();
  tool.reset();
  press(canvas);
  EXPECT_EQ(order, "guide ");
}

}  // namespace
}  // namespace insonate::ui
