#include "Waiting.h"

#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest/QTest>
#include <algorithm>

namespace insonate {
namespace {

class Busy final : public ui::Workspace {
 public:
  void setCase(std::shared_ptr<const PatientCase> patient) override { shown = std::move(patient); }
  QString interruptionWarning() const override { return ending; }
  QString windowCloseWarning() const override { return unwritten; }
  QString workspaceChangeBlocker() const override { return keeps; }
  std::shared_ptr<const PatientCase> shown;
  QString ending, unwritten, keeps;
};

class Ending : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().clear();
    window.addWorkspace("train", "Train", "train", train);
    window.show();
    window.open(test::writtenSmallCase(home, "block"));
    ASSERT_TRUE(test::waitUntil([&] { return train->shown != nullptr; }));
  }
  QDialog* question() { return window.findChild<QDialog*>(); }
  bool answer(const char* button) {
    QTest::mouseClick(question()->findChild<QPushButton*>(button), Qt::LeftButton);
    return test::waitUntil([&] { return !question(); });
  }

  QTemporaryDir home;
  ui::MainWindow window;
  Busy* train = new Busy;
};

TEST_F(Ending, AWorkspaceKeepsTheWindowAndTheStatusBarSaysWhy) {
  window.addWorkspace("review", "Review", "review", new ui::EmptyWorkspace({"review", "Nothing yet", {}, {}, {}}));
  train->keeps = "A test is in progress.";
  window.showWorkspace("review");
  EXPECT_EQ(window.currentId(), "train");
  EXPECT_EQ(window.statusText(), "A test is in progress.");
  for (auto* tab : window.findChildren<QToolButton*>()) {
    if (tab->accessibleName() == "Review") tab->click();
    if (tab->accessibleName() != "Train") continue;
    EXPECT_TRUE(tab->isChecked()) << "the header shows where one is";
  }
  EXPECT_EQ(window.currentId(), "train");
  train->keeps.clear();
  window.showWorkspace("review");
  EXPECT_EQ(window.currentId(), "review");
}

TEST_F(Ending, IsAskedBeforeAnotherCaseOrTheWindowClosing) {
  const auto before = train->shown;
  train->ending = "An attempt is being made.";
  Q_EMIT train->caseRequested(home.filePath("block"));
  ASSERT_TRUE(question()) << "another workspace may not end it unasked either";
  bool said = false;
  for (const QLabel* label : question()->findChildren<QLabel*>()) said |= label->text() == train->ending;
  EXPECT_TRUE(said);
  EXPECT_FALSE(question()->findChild<QPushButton*>("save")) << "there is nothing to save";
  ASSERT_TRUE(answer("keep"));
  EXPECT_FALSE(window.close());
  ASSERT_TRUE(question() && answer("keep"));
  EXPECT_EQ(train->shown, before);
  window.open(home.filePath("block"));
  ASSERT_TRUE(question() && answer("goOn"));
  EXPECT_TRUE(test::waitUntil([&] { return train->shown != before; }));
}

TEST_F(Ending, AnUnwrittenFileIsAskedAboutOnlyBeforeTheWindowCloses) {
  const auto before = train->shown;
  train->unwritten = "A file is not written yet.";
  window.open(home.filePath("block"));
  EXPECT_FALSE(question()) << "the file is written all the same";
  ASSERT_TRUE(test::waitUntil([&] { return train->shown != before; }));
  EXPECT_FALSE(window.close());
  ASSERT_TRUE(question());
  EXPECT_TRUE(std::ranges::any_of(question()->findChildren<QLabel*>(),
                                  [&](const QLabel* label) { return label->text() == train->unwritten; }));
  ASSERT_TRUE(answer("keep"));
  train->unwritten.clear();
  EXPECT_TRUE(window.close());
}

TEST_F(Ending, IsNotAskedWhereNothingEnds) {
  const auto before = train->shown;
  window.open(home.filePath("block"));
  EXPECT_FALSE(question());
  EXPECT_TRUE(test::waitUntil([&] { return train->shown != before; }));
}

}  // namespace
}  // namespace insonate
