#include "Waiting.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/review/ReviewWorkspace.h>
#include <insonate/train/TrainWorkspace.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/MainWindow.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/AccessibleNames.h>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QDialog>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <memory>

namespace {

using namespace insonate;
using test::expectNames;
using test::isInteractive;
using test::waitUntil;
using test::what;

class Accessibility : public testing::Test {
 protected:
  void SetUp() override {
    window.addWorkspace("prepare", "Prepare", "prepare", new ui::EmptyWorkspace({"prepare", "Prepare", {}, {}, {}}));
    window.addWorkspace("train", "Train", "train", train);
    window.addWorkspace("review", "Review", "review", new review::ReviewWorkspace(window.tasks()));
    window.showWorkspace("train");
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    // Nobody manages windows here.
    QApplication::setActiveWindow(&window);
  }

  QTemporaryDir home;
  ui::MainWindow window;
  train::TrainWorkspace* train = new train::TrainWorkspace;
};

TEST_F(Accessibility, EverythingInTheWindowHasANameAndATooltip) {
  EXPECT_GT(expectNames(&window, true), 70);
}

TEST_F(Accessibility, EverythingInTheWindowIsReachedByKeyboard) {
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    if (!isInteractive(widget)) continue;
    // A widget that takes the keyboard by its proxy is reached through that.
    EXPECT_TRUE(widget->focusPolicy() & Qt::TabFocus) << what(widget) << " cannot be reached by Tab";
  }
}

TEST_F(Accessibility, WhatHasTheKeyboardIsSeen) {
  int changed = 0, seen = 0;
  for (auto* button : window.findChildren<QAbstractButton*>()) {
    if (!button->isVisible() || !button->isEnabled() || !(button->focusPolicy() & Qt::TabFocus)) continue;
    window.setFocus();
    const QImage without = button->grab().toImage();
    button->setFocus(Qt::TabFocusReason);
    if (!button->hasFocus()) continue;
    ++seen;
    changed += button->grab().toImage() != without;
  }
  EXPECT_GT(seen, 5);
  EXPECT_EQ(changed, seen);
}

TEST_F(Accessibility, TheImportDialogHasNames) {
  const QString folder = home.filePath("dicom");
  ASSERT_TRUE(writeDicomSeries(test::smallCase().ct, folder.toStdString(), {.seed = "names"}));
  window.open(folder);
  QDialog* dialog = nullptr;
  ASSERT_TRUE(waitUntil([&] {
    dialog = window.findChild<QDialog*>();
    return dialog && dialog->isVisible();
  }));
  EXPECT_GT(expectNames(dialog, false), 3);
  // Enter in the table is Import, and imports once.
  auto* table = dialog->findChild<QTableWidget*>();
  ASSERT_TRUE(
      waitUntil([&] { return !dialog->findChildren<QAbstractButton*>().isEmpty() && table->currentRow() == 0; }));
  QTest::keyClick(table, Qt::Key_Return);
  EXPECT_TRUE(waitUntil([&] { return window.current().patient != nullptr; }));
}

TEST_F(Accessibility, HelpAndErrorsHaveNames) {
  QTest::keyClick(&window, Qt::Key_F1);
  auto* help = window.findChild<QDialog*>();
  ASSERT_TRUE(help);
  EXPECT_GE(expectNames(help, false), 2);
  window.errors().showError("Something is wrong.", "Do this.", "and that\nis why");
  expectNames(&window.errors(), true);
}

}  // namespace
