#include "Waiting.h"

#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/RecentCases.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/ByteSearch.h>
#include <support/MarkedSeries.h>

#include <QAction>
#include <QDialog>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest/QTest>

namespace {

using namespace insonate;
using test::waitUntil;

/// A case that came in through the window: its folder, and all that the program keeps for its user.
TEST(WindowDeidentification, NothingOfADicomSeriesIsWritten) {
  QTemporaryDir input, kept;
  test::writeMarkedSeries(input.path().toStdString(), 5);
  const QString target = kept.filePath("case");
  {
    ui::MainWindow window;
    window.show();
    window.open(input.path());
    ASSERT_TRUE(waitUntil([&] { return window.findChild<QDialog*>() != nullptr; }));
    QPushButton* import = nullptr;
    for (auto* button : window.findChild<QDialog*>()->findChildren<QPushButton*>())
      if (button->text().remove('&') == "Import") import = button;
    ASSERT_TRUE(import && import->isEnabled());
    QTest::mouseClick(import, Qt::LeftButton);
    ASSERT_TRUE(waitUntil([&] { return window.current().patient && window.saveAction()->isEnabled(); }));
    test::answerSaveDialog(window, target);
    window.saveAction()->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.current().folder == target; }));
    window.closeAtOnce();
  }
  QSettings().sync();
  ASSERT_FALSE(ui::recentCases().empty());
  int files = 0;
  EXPECT_THAT(test::marksBelow(kept.path().toStdString(), test::kMarks, files), testing::IsEmpty());
  EXPECT_GE(files, 4);
  for (const auto place : {QStandardPaths::GenericConfigLocation, QStandardPaths::GenericCacheLocation,
                           QStandardPaths::GenericDataLocation}) {
    const std::string folder = QStandardPaths::writableLocation(place).toStdString();
    if (!std::filesystem::exists(folder)) continue;
    EXPECT_THAT(test::marksBelow(folder, test::kMarks, files), testing::IsEmpty()) << folder;
  }
}

}  // namespace
