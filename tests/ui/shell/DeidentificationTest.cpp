#include "Waiting.h"

#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/RecentCases.h>
#include <insonate/ui/TaskBar.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <support/ByteSearch.h>
#include <support/MarkedSeries.h>
#include <support/SmallCase.h>

#include <QAction>
#include <QDialog>
#include <QFile>
#include <QFileDialog>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest/QTest>

namespace {

using namespace insonate;
using test::waitUntil;

/// Searches the files that the program keeps for its user: settings, cache, data.
void expectNoMarksInWhatIsKept() {
  QSettings().sync();
  int files = 0;
  for (const auto place : {QStandardPaths::GenericConfigLocation, QStandardPaths::GenericCacheLocation,
                           QStandardPaths::GenericDataLocation}) {
    const std::string folder = QStandardPaths::writableLocation(place).toStdString();
    if (!std::filesystem::exists(folder)) continue;
    EXPECT_THAT(test::marksBelow(folder, test::kMarks, files), testing::IsEmpty()) << folder;
  }
}

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
    ASSERT_TRUE(waitUntil(
        [&] { return window.current().patient && window.commands().action("window.case.save")->isEnabled(); }));
    test::answerFileDialog(window, target);
    window.commands().action("window.case.save")->trigger();
    ASSERT_TRUE(waitUntil([&] { return window.current().folder == target; }));
    window.closeAtOnce();
  }
  ASSERT_FALSE(ui::recentCases().empty());
  int files = 0;
  EXPECT_THAT(test::marksBelow(kept.path().toStdString(), test::kMarks, files), testing::IsEmpty());
  EXPECT_GE(files, 4);
  expectNoMarksInWhatIsKept();
}

/// The folders of hospitals are named after patients, and files in them are chosen in dialogs.
TEST(WindowDeidentification, WherePatientsFilesLieIsNotKept) {
  QTemporaryDir input;
  test::writeMarkedSeries(input.path().toStdString(), 5);
  const QString series = input.path() + QStringLiteral("/ZQXMARK^Jane 19470311");
  ui::MainWindow window;
  window.show();
  test::answerFileDialog(window, series + QStringLiteral("/ZQXMARK slice 0.dcm"));
  for (auto* action : window.actions())
    if (action->text() == QStringLiteral("Import CT ...")) action->trigger();
  ASSERT_TRUE(waitUntil([&] { return window.findChild<QDialog*>() || window.current().patient; }));
  EXPECT_EQ(window.findChild<QFileDialog*>(), nullptr);
  if (auto* dialog = window.findChild<QDialog*>()) dialog->reject();
  QTemporaryDir home;
  window.open(test::writtenSmallCase(home, "case"));
  ASSERT_TRUE(waitUntil([&] { return window.current().patient && !window.findChild<ui::TaskBar*>()->isRunning(); }));
  const QString labels = series + QStringLiteral("/ZQXMARK.nrrd");
  test::answerFileDialog(window, labels);
  ASSERT_TRUE(QFile::copy(series + QStringLiteral("/ZQXMARK slice 0.dcm"), labels));
  window.findChild<QAction*>("importLabels")->trigger();
  ASSERT_TRUE(waitUntil([&] { return !window.findChild<ui::TaskBar*>()->isRunning(); }));
  // Nor by a dialog that comes later.
  QTemporaryDir out;
  test::answerFileDialog(window, out.filePath("labels.seg.nrrd"));
  window.findChild<QAction*>("exportLabels")->trigger();
  ASSERT_TRUE(waitUntil([&] { return QFile::exists(out.filePath("labels.seg.nrrd")); }));
  window.closeAtOnce();
  expectNoMarksInWhatIsKept();
}

/// A folder is taken by a button of the dialog, as it is shown or selected.
TEST(ImportDialog, TakesTheFolderThatItShows) {
  QTemporaryDir home;
  ASSERT_TRUE(writeDicomSeries(test::smallCase().ct, home.filePath("series").toStdString(), {.seed = "s"}));
  ui::MainWindow window;
  window.show();
  QTimer looking;
  QObject::connect(&looking, &QTimer::timeout, [&] {
    auto* dialog = window.findChild<QFileDialog*>();
    if (!dialog || !dialog->isVisible()) return;
    looking.stop();
    dialog->setDirectory(home.filePath("series"));
    auto* take = dialog->findChild<QPushButton*>("importFolder");
    ASSERT_TRUE(take);
    QTest::mouseClick(take, Qt::LeftButton);
  });
  looking.start(20);
  window.commands().action("window.case.import")->trigger();
  const auto* series = [&]() -> QTableWidget* {
    QTableWidget* table = nullptr;
    waitUntil([&] { return (table = window.findChild<QTableWidget*>()) != nullptr; });
    return table;
  }();
  ASSERT_TRUE(series);
  EXPECT_EQ(series->rowCount(), 1);
  window.findChild<QDialog*>()->reject();
  window.closeAtOnce();
}

}  // namespace
