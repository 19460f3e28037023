#include "LibraryModel.h"
#include "LibraryReader.h"
#include "LibraryWindow.h"
#include "Waiting.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/ui/KnownCases.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <ui/support/PlainTexts.h>
#include <ui/support/WholeWords.h>

#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QtTest/QTest>

namespace {

using namespace insonate;
using namespace insonate::ui;
using test::waitUntil;

LibraryEntry entry(const QString& title, const QString& grade, bool fit) {
  LibraryEntry one;
  one.place = QStringLiteral("/cases/") + title;
  one.title = title, one.grade = grade, one.fit = fit;
  one.structures = QStringList{"skin", "vein"};
  one.state = LibraryEntry::State::Known;
  return one;
}

QStringList titles(const LibraryFilter& filter) {
  QStringList all;
  for (int row = 0; row < filter.rowCount(); ++row) all << filter.entry(filter.index(row, 0)).title;
  return all;
}

TEST(LibraryFilter, SearchesFiltersAndSorts) {
  LibraryModel model;
  LibraryFilter filter(model, nullptr);
  model.setEntries({entry("A new import", "", false), entry("Hard one", "hard", true), entry("Easy two", "easy", false),
                    entry("An easy one", "easy", true)});
  EXPECT_EQ(titles(filter), (QStringList{"An easy one", "Easy two", "Hard one", "A new import"}))
      << "easy first, then by title; what has no difficulty comes last, as the choice of orders says";
  filter.setWords("ONE ea");
  EXPECT_EQ(titles(filter), (QStringList{"An easy one"}));
  filter.setWords("vein nothing");
  EXPECT_TRUE(titles(filter).isEmpty());
  filter.setWords({});
  filter.setGrade("easy");
  EXPECT_EQ(titles(filter).size(), 2);
  filter.setFitness(LibraryFilter::Fitness::Unfit);
  EXPECT_EQ(titles(filter), (QStringList{"Easy two"}));
}

class Library : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(home_.isValid());
    QSettings().setValue("library/folders", QStringList{home_.filePath("cases")});
    QDir(home_.path()).mkpath("cases/deeper");
  }
  void TearDown() override { QSettings().remove("library/folders"); }

  QString write(const PatientCase& patient, const QString& name) {
    const QString folder = home_.filePath("cases/" + name);
    EXPECT_TRUE(saveCaseVersion(patient, folder.toStdString(), "2026-11-22", ""));
    return folder;
  }
  void openWindow() {
    window_ = new LibraryWindow(nullptr);
    window_->setAttribute(Qt::WA_DeleteOnClose, false);
    QObject::connect(window_, &LibraryWindow::caseChosen,
                     [this](const QString& place, const QString& room) { place_ = place, room_ = room; });
    window_->show();
    window_->activateWindow();
  }
  void closeWindow() { delete window_; }
  template <class T>
  T* child(const char* name) {
    T* found = window_->findChild<T*>(name);
    EXPECT_TRUE(found) << name;
    return found;
  }
  const LibraryFilter& cases() { return *static_cast<LibraryFilter*>(child<QListView>("libraryList")->model()); }
  const LibraryEntry* find(const QString& title) {
    for (int row = 0; row < cases().rowCount(); ++row)
      if (const LibraryEntry& one = cases().entry(cases().index(row, 0)); one.title == title) return &one;
    return nullptr;
  }
  void choose(const QString& title) {
    for (int row = 0; row < cases().rowCount(); ++row)
      if (cases().entry(cases().index(row, 0)).title == title)
        child<QListView>("libraryList")->setCurrentIndex(cases().index(row, 0));
  }

  QTemporaryDir home_;
  LibraryWindow* window_ = nullptr;
  QString place_, room_;
};

TEST_F(Library, RemovesWhatKilledProgramsLeftHalfWritten) {
  const QString left = home_.filePath("cases/deeper/.neck.part-1-2.case");
  QDir().mkpath(left + "/half");
  openWindow();
  EXPECT_TRUE(waitUntil([&] { return !QFileInfo::exists(left); }));
  closeWindow();
}

TEST_F(Library, ListsFoldersAndBuiltInNecksWithWhatTheyShow) {
  PatientCase patient = test::smallAttemptCase();
  patient.manifest.title = "My block";
  patient.manifest.difficulty = "moderate";
  const QString folder = write(patient, "deeper/block");
  openWindow();
  ASSERT_TRUE(waitUntil([&] { return find("My block") && find("My block")->state == LibraryEntry::State::Known; }));
  const LibraryEntry one = *find("My block");
  EXPECT_EQ(one.place, folder);
  EXPECT_EQ(one.grade, "moderate");
  EXPECT_TRUE(one.graded);
  EXPECT_FALSE(one.fit);
  EXPECT_TRUE(one.errors.join(' ').contains("only 17 mm wide")) << one.errors.join("; ").toStdString();
  EXPECT_TRUE(one.structures.contains("artery"));
  EXPECT_EQ(one.version, 1);
  EXPECT_FALSE(one.slice.isNull());
  EXPECT_FALSE(one.ultrasound.isNull());
  EXPECT_EQ(cases().rowCount(), builtInCaseNames().size() + 1);
  EXPECT_EQ(test::expectWholeWords(window_), 7);

  // Search as one types, then Enter.
  QTest::keyClicks(child<QLineEdit>("librarySearch"), "block");
  EXPECT_EQ(cases().rowCount(), 1);
  choose("My block");
  QTest::keyClick(child<QLineEdit>("librarySearch"), Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(place_, folder);
  EXPECT_EQ(room_, "prepare");
  EXPECT_FALSE(window_->isVisible());
  closeWindow();
}

/// Instructors see which warnings a case has, not only how many.
TEST_F(Library, NamesTheWarningsOfACase) {
  PatientCase patient = test::smallAttemptCase();
  patient.manifest.startPoses.front().position_mm.y = -5;
  const QString folder = write(patient, "above the skin"), cache = home_.filePath("cache");
  const LibraryEntry read = knownCase(listedCase(folder, false), cache, {});
  EXPECT_TRUE(read.warnings.join(' ').contains("is not on the skin")) << read.warnings.join("; ").toStdString();
  const LibraryEntry kept = knownCase(listedCase(folder, false), cache, [](std::string_view, double) { return false; });
  EXPECT_EQ(kept.warnings, read.warnings) << "also from the facts that were kept";
  LibraryModel model;
  model.setEntries({kept});
  for (const int role : {Qt::ToolTipRole, Qt::AccessibleTextRole}) {
    const QString text = model.data(model.index(0), role).toString();
    for (const QString& warning : read.warnings) EXPECT_TRUE(text.contains(warning)) << text.toStdString();
  }
}

TEST_F(Library, FromPrepareACaseOpensForEditing) {
  write(test::smallCase(), "block");
  window_ = new LibraryWindow(nullptr, QStringLiteral("prepare"));
  window_->setAttribute(Qt::WA_DeleteOnClose, false);
  QObject::connect(window_, &LibraryWindow::caseChosen,
                   [this](const QString& place, const QString& room) { place_ = place, room_ = room; });
  window_->show();
  ASSERT_TRUE(waitUntil([&] { return find("Small block"); }));
  choose("Small block");
  auto* list = child<QListView>("libraryList");
  const QPoint at = list->visualRect(list->currentIndex()).center();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(list->viewport(), Qt::LeftButton, {}, at);
  EXPECT_EQ(room_, "prepare");
  window_->show();
  QTest::keyClick(list, Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(room_, "train");
  window_->show();
  QTest::keyClick(list, Qt::Key_Return);
  EXPECT_EQ(room_, "prepare");
  EXPECT_TRUE(child<QPushButton>("libraryPrepare")->toolTip().contains("double click"));
  EXPECT_FALSE(child<QLabel>("libraryState")->text().contains("more"));
  closeWindow();
}

TEST_F(Library, HostileTitlesAreTexts) {
  PatientCase patient = test::smallCase();
  patient.manifest.title = patient.manifest.description = test::endlessText().toStdString();
  write(patient, "hostile");
  openWindow();
  const QString title = QString::fromStdString(patient.manifest.title);
  ASSERT_TRUE(waitUntil([&] { return find(title) && find(title)->state == LibraryEntry::State::Known; }));
  choose(title);
  test::expectPlain(*window_);
  closeWindow();
}

TEST_F(Library, BrokenCaseIsShownWithItsReasonAndDoesNotOpen) {
  const QString folder = write(test::smallCase(), "broken");
  QFile file(folder + "/case.json");
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{");
  file.close();
  const QString truncated = write(test::smallCase(), "truncated");
  ASSERT_TRUE(QFile::resize(truncated + "/ct.nrrd", 300));
  openWindow();
  ASSERT_TRUE(waitUntil([&] {
    const auto* one = find("Small block");
    return find("broken") && one && one->state == LibraryEntry::State::Broken;
  }));
  EXPECT_TRUE(find("broken")->error.contains("JSON"));
  choose("broken");
  EXPECT_FALSE(child<QPushButton>("libraryTrain")->isEnabled());
  QTest::keyClick(child<QListView>("libraryList"), Qt::Key_Return);
  EXPECT_TRUE(place_.isEmpty());
  EXPECT_TRUE(window_->isVisible());
  closeWindow();
}

TEST_F(Library, WhatIsKeptHoldsNoNameAndIsUsedAgain) {
  PatientCase patient = test::smallAttemptCase();
  patient.manifest.title = "Quite secret";
  const QString folder = write(patient, "secret");
  const QString cache = home_.filePath("cache");
  const LibraryEntry first = knownCase(listedCase(folder, false), cache, {});
  ASSERT_EQ(first.state, LibraryEntry::State::Known);
  for (const QString& name : QDir(cache).entryList(QDir::Files)) {
    QFile kept(QDir(cache).filePath(name));
    ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
    const QByteArray bytes = kept.readAll() + name.toUtf8();
    EXPECT_FALSE(bytes.contains("secret")) << name.toStdString();
    EXPECT_FALSE(bytes.contains(home_.path().toUtf8())) << name.toStdString();
  }
  // From the cache: without volumes that could be read.
  const auto refuse = [](std::string_view, double) { return false; };
  const LibraryEntry again = knownCase(listedCase(folder, false), cache, refuse);
  EXPECT_EQ(again.state, LibraryEntry::State::Known);
  EXPECT_EQ(again.reason, first.reason);
  EXPECT_EQ(again.slice.size(), first.slice.size());
  // Saved with other labels, it is looked at anew.
  std::ranges::replace(patient.labels.voxels, std::uint8_t{kArtery}, std::uint8_t{kSoftTissue});
  write(patient, "secret");
  const LibraryEntry changed = knownCase(listedCase(folder, false), cache, {});
  EXPECT_FALSE(changed.structures.contains("artery"));
  EXPECT_EQ(changed.version, 2);
}

/// Regression: with a full disk, facts about one neck were taken for every other.
TEST_F(Library, NecksThatCannotBeKeptAreToldApart) {
  QFile none(home_.filePath("no folder"));
  ASSERT_TRUE(none.open(QIODevice::WriteOnly));
  const QByteArray before = qgetenv("XDG_CACHE_HOME");
  qputenv("XDG_CACHE_HOME", none.fileName().toUtf8());
  const QString cache = home_.filePath("cache");
  const LibraryEntry textbook = knownCase(listedCase("textbook", true), cache, {});
  const LibraryEntry collapsed = knownCase(listedCase("collapsed-vein", true), cache, {});
  qputenv("XDG_CACHE_HOME", before);
  ASSERT_EQ(collapsed.state, LibraryEntry::State::Known);
  EXPECT_NE(collapsed.reason, textbook.reason);
}

TEST_F(Library, DrawsALabelOfTheAuthorsOwnAsItsTissue) {
  const auto ultrasoundOf = [this](const PatientCase& patient, const QString& name) {
    const QString folder = write(patient, name);
    return knownCase(listedCase(folder, false), home_.filePath("cache"), {}).ultrasound;
  };
  const QImage bone = ultrasoundOf(test::smallCase(), "bone");
  EXPECT_FALSE(bone.isNull());
  EXPECT_NE(ultrasoundOf(test::smallCaseWithOwnLabel(kSoftTissue), "soft"), bone);
  EXPECT_EQ(ultrasoundOf(test::smallCaseWithOwnLabel(kBone), "rib"), bone);
}

TEST_F(Library, TwoHundredCasesAreListedAndReachedByKeys) {
  for (int n = 0; n < 200; ++n) {
    const QString folder = home_.filePath(QStringLiteral("cases/case%1").arg(n, 3, 10, QLatin1Char('0')));
    QDir().mkpath(folder);
    QFile file(folder + "/case.json");
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{\"schema_version\": 1}");
  }
  openWindow();
  ASSERT_TRUE(waitUntil([&] {
    return cases().rowCount() == 200 + builtInCaseNames().size() && find("case199") &&
           find("case199")->state == LibraryEntry::State::Broken;
  }));
  EXPECT_TRUE(find("case007")->error.contains("ct.nrrd")) << find("case007")->error.toStdString();
  auto* list = child<QListView>("libraryList");
  EXPECT_TRUE(list->uniformItemSizes()) << "no row is measured before it is seen";
  child<QComboBox>("libraryOrder")->setCurrentIndex(1);
  list->setFocus();
  QTest::keyClick(list, Qt::Key_End);
  EXPECT_EQ(list->currentIndex().row(), cases().rowCount() - 1);
  EXPECT_TRUE(list->viewport()->rect().intersects(list->visualRect(list->currentIndex())));
  closeWindow();
}

}  // namespace
