#include "LibraryModel.h"
#include "LibraryReader.h"
#include "LibraryWindow.h"
#include "Waiting.h"

#include <insonate/cases/CaseVersions.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/Pauses.h>

#include <QComboBox>
#include <QElapsedTimer>
#include <QLineEdit>
#include <QListView>
#include <QScrollBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest/QTest>
#include <algorithm>
#include <cstdio>
#include <memory>

namespace {

using namespace insonate;
using namespace insonate::ui;
using test::Pauses;
using test::waitUntil;

constexpr int kCases = 200, kVersions = 50;

class LibrarySpeed : public testing::Test {
 protected:
  void SetUp() override {
    QSettings().setValue("library/folders", QStringList{home_.path()});
    // The library comes out of the program's window, which has read fonts and style: 40 ms that any first window takes.
    first_.addItem("easy");
    first_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&first_));
    QTest::qWait(100);
  }
  void TearDown() override { QSettings().remove("library/folders"); }

  void writeCases() {
    PatientCase patient = test::smallAttemptCase();
    patient.manifest.difficulty = "moderate";
    for (int n = 0; n < kCases; ++n) {
      patient.manifest.title = "Neck " + std::to_string(n);
      patient.ct.voxels[std::size_t(n)] = 1;
      const auto saved = saveCaseVersion(patient, home_.filePath(QString::number(n)).toStdString(), "2026-11-22", "");
      ASSERT_TRUE(saved) << saved.error().message;
    }
  }

  template <class T>
  T* child(LibraryWindow& window, const char* name) {
    T* found = window.findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }

  /// Opens the window and waits until all is known.
  std::unique_ptr<LibraryWindow> open(const char* when) {
    Pauses pauses;
    QElapsedTimer clock;
    clock.start();
    auto window = std::make_unique<LibraryWindow>(nullptr);
    window->setAttribute(Qt::WA_DeleteOnClose, false);
    window->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    const double shown_ms = double(clock.elapsed());
    const auto& cases = *static_cast<LibraryFilter*>(child<QListView>(*window, "libraryList")->model());
    EXPECT_TRUE(waitUntil([&] { return cases.rowCount() >= kCases; }));
    const double listed_ms = double(clock.elapsed());
    const auto isKnown = [&](int row) {
      const LibraryEntry& one = cases.entry(cases.index(row, 0));
      return one.builtIn || one.state == LibraryEntry::State::Known;
    };
    EXPECT_TRUE(waitUntil([&] {
      for (int row = 0; row < cases.rowCount(); ++row)
        if (!isKnown(row)) return false;
      return true;
    }));
    std::printf("%d cases, %s: window %.0f ms, titles %.0f ms, all known %lld ms; longest work of the window %.1f ms\n",
                kCases, when, shown_ms, listed_ms, clock.elapsed(), pauses.longest_ms());
    return window;
  }

  /// The longest work of the window's thread while `action` is done for each of `count` numbers, and shown.
  template <class Action>
  void time(const char* what, QWidget* shown, int count, Action action) {
    double longest_ms = 0;
    for (int n = 0; n < count; ++n) {
      QTest::qWait(5);
      const double start_ms = threadTime_ms();
      action(n);
      QCoreApplication::sendPostedEvents();
      shown->repaint();
      longest_ms = std::max(longest_ms, threadTime_ms() - start_ms);
    }
    std::printf("%s: %.1f ms at most\n", what, longest_ms);
  }

  QTemporaryDir home_;
  QComboBox first_;
};

TEST_F(LibrarySpeed, OfManyCases) {
  writeCases();
  open("seen for the first time");
  const auto window = open("known from before");
  auto* list = child<QListView>(*window, "libraryList");
  auto* search = child<QLineEdit>(*window, "librarySearch");
  const QString words = QStringLiteral("artery 19 moderate");
  time("a letter of a search", list->viewport(), int(words.size()),
       [&](int n) { QTest::keyClick(search, words[n].toLatin1()); });
  EXPECT_GE(list->model()->rowCount(), 11);
  EXPECT_LE(list->model()->rowCount(), kCases / 10);
  search->clear();
  auto* order = child<QComboBox>(*window, "libraryOrder");
  time("another order", list->viewport(), 6, [&](int n) { order->setCurrentIndex(n % order->count()); });
  auto* grade = child<QComboBox>(*window, "libraryGrade");
  time("a difficulty", list->viewport(), 8, [&](int n) { grade->setCurrentIndex(n % grade->count()); });
  grade->setCurrentIndex(0);
  auto* bar = list->verticalScrollBar();
  time("a page of scrolling", list->viewport(), 20,
       [&](int n) { bar->setValue(bar->minimum() + (bar->maximum() - bar->minimum()) * n / 19); });
  EXPECT_EQ(bar->value(), bar->maximum());
}

TEST_F(LibrarySpeed, OfManyVersions) {
  const auto folder = home_.filePath("case").toStdString();
  PatientCase patient = test::smallAttemptCase();
  for (int n = 0; n < kVersions; ++n) {
    patient.ct.voxels[0] = std::int16_t(n + 2);
    ASSERT_TRUE(saveCaseVersion(patient, folder, "2026-11-22", ""));
  }
  QElapsedTimer clock;
  clock.start();
  const auto versions = versionsOf(folder);
  std::printf("%d versions listed in %lld ms\n", kVersions, clock.elapsed());
  EXPECT_GE(versions.size(), std::size_t(kVersions));
}

}  // namespace
