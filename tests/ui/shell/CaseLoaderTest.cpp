#include "Waiting.h"
#include "cases/SeriesDialog.h"

#include <insonate/cases/DicomWriter.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>
#include <unit/cases/DicomFiles.h>

#include <QApplication>
#include <QCheckBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QWidget>
#include <QtTest/QTest>
#include <optional>

namespace {

using namespace insonate;
using test::waitUntil;

class CaseLoader : public testing::Test {
 protected:
  CaseLoader() : tasks(&window), loader(tasks, &window) {
    QObject::connect(&loader, &ui::CaseLoader::loaded, [this](const ui::LoadedCase& one) { loaded = one; });
    QObject::connect(&loader, &ui::CaseLoader::failed, [this](const QString& what) { failed = what; });
    QObject::connect(&loader, &ui::CaseLoader::cancelled, [this] { ++cancelled; });
    QObject::connect(&loader, &ui::CaseLoader::saved, [this](const ui::SavedCase& one) { saved = one.folder; });
    window.show();
  }
  bool ended() const { return loaded || !failed.isEmpty() || cancelled > 0 || !saved.isEmpty(); }
  QDialog* dialog() {
    EXPECT_TRUE(waitUntil([this] { return window.findChild<QDialog*>() || ended(); }));
    return window.findChild<QDialog*>();
  }
  QPushButton* button(QDialog* in, const QString& text) {
    for (auto* one : in->findChildren<QPushButton*>())
      if (one->text().remove('&') == text && !one->parentWidget()->inherits("insonate::ui::TaskBar")) return one;
    return nullptr;
  }
  QString writtenDicom(const QString& name) {
    const QString folder = home.filePath(name);
    EXPECT_TRUE(writeDicomSeries(test::smallCase().ct, folder.toStdString(), {.seed = name.toStdString()}));
    return folder;
  }

  /// The choice in the dialog, once the series was read; null where there is none.
  QCheckBox* shiftOfferedFor(const QString& path) {
    if (QDialog* before = window.findChild<QDialog*>()) before->reject();
    EXPECT_TRUE(waitUntil([this] { return !window.findChild<QDialog*>(); }));
    cancelled = 0;
    loaded.reset();
    loader.open(path);
    QDialog* choice = dialog();
    if (!choice) return nullptr;
    const auto* running = choice->findChild<ui::TaskBar*>();
    EXPECT_TRUE(waitUntil([&] { return !running->isRunning(); }));
    auto* shift = choice->findChild<QCheckBox*>("shiftValues");
    return shift->isVisible() ? shift : nullptr;
  }

  QTemporaryDir home;
  QWidget window;
  ui::TaskBar tasks;
  ui::CaseLoader loader;
  std::optional<ui::LoadedCase> loaded;
  QString failed, saved;
  int cancelled = 0;
};

TEST_F(CaseLoader, OpensACaseFolderAndAnyOfItsFiles) {
  const QString folder = test::writtenSmallCase(home, "block");
  loader.open(folder);
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  ASSERT_TRUE(loaded) << failed.toStdString();
  EXPECT_EQ(loaded->patient->manifest.title, "Small block");
  EXPECT_EQ(loaded->folder, QDir(folder).absolutePath());
  loaded.reset();
  loader.open(folder + "/labels.seg.nrrd");
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  EXPECT_TRUE(loaded);
}

TEST_F(CaseLoader, SaysWhyAFolderIsNoCase) {
  loader.open(home.filePath("nothing"));
  EXPECT_TRUE(failed.contains("There is no file or folder")) << failed.toStdString();
  failed.clear();
  QDir(home.path()).mkdir("empty");
  loader.open(home.filePath("empty"));
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  EXPECT_FALSE(failed.isEmpty());
  EXPECT_FALSE(loaded);
}

TEST_F(CaseLoader, SaysWhatIsWrongWithABrokenCase) {
  const QString folder = test::writtenSmallCase(home, "broken");
  ASSERT_TRUE(QFile::resize(folder + "/ct.nrrd", 700));
  loader.open(folder);
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  EXPECT_TRUE(failed.contains("ct.nrrd")) << failed.toStdString();
}

TEST_F(CaseLoader, ImportsTheChosenSeries) {
  loader.open(writtenDicom("dicom"));
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  auto* table = choice->findChild<QTableWidget*>();
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 0)->text(), "CT");
  EXPECT_EQ(table->item(0, 1)->text(), "49 x 41 x 17");
  EXPECT_EQ(table->item(0, 2)->text(), "1.00 x 1.00 x 1.00");
  EXPECT_TRUE(table->isColumnHidden(3)) << "no kernel is told";
  EXPECT_TRUE(table->item(0, 7)->text().startsWith("... ")) << "which of several";
  choice->findChild<QCheckBox*>()->setChecked(false);
  QTest::mouseClick(button(choice, "Import"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  ASSERT_TRUE(loaded) << failed.toStdString();
  EXPECT_EQ(loaded->patient->ct.geometry.size, (std::array{49, 41, 17}));
  EXPECT_TRUE(loaded->folder.isEmpty()) << "not saved yet";

  loader.save(loaded->patient, home.filePath("kept"));
  ASSERT_TRUE(waitUntil([this] { return !saved.isEmpty() || !failed.isEmpty(); }));
  EXPECT_EQ(ui::caseFolderOf(home.filePath("kept")), home.filePath("kept")) << failed.toStdString();
}

/// HU + 1024 as scanners store it, without saying so.
TEST_F(CaseLoader, OffersHounsfieldUnitsWhereTheirOffsetIsMissing) {
  EXPECT_FALSE(shiftOfferedFor(writtenDicom("right")));
  CtVolume stored = test::smallCase().ct;
  for (std::int16_t& value : stored.voxels) value = std::int16_t(value + 1024);
  const QString folder = home.filePath("stored");
  ASSERT_TRUE(writeDicomSeries(stored, folder.toStdString(), {.seed = "stored"}));
  for (const bool wanted : {false, true}) {
    auto* shift = shiftOfferedFor(folder);
    ASSERT_TRUE(shift);
    EXPECT_EQ(shift->text(), "Shift all values by -1024: air, now 0, becomes -1024 HU");
    EXPECT_TRUE(shift->isChecked());
    const auto picture = [&] {
      for (const auto* label : dialog()->findChildren<QLabel*>())
        if (label->pixmap(Qt::ReturnByValue).width() > 0) return label->pixmap(Qt::ReturnByValue).toImage();
      return QImage();
    };
    const QImage shifted = picture();
    shift->setChecked(false);
    EXPECT_NE(picture(), shifted) << "it is seen which is right";
    shift->setChecked(wanted);
    QTest::mouseClick(button(dialog(), "Import"), Qt::LeftButton);
    ASSERT_TRUE(waitUntil([this] { return ended(); }));
    ASSERT_TRUE(loaded) << failed.toStdString();
    EXPECT_EQ(loaded->patient->ct.voxels, wanted ? test::smallCase().ct.voxels : stored.voxels);
    EXPECT_EQ(loaded->notes.join(" ").contains("-1024 was added to every value"), wanted);
  }
}

TEST_F(CaseLoader, AScaleThatSaturatesAsksBeforeTheImport) {
  const QString folder = home.filePath("dense");
  ASSERT_TRUE(writeDicomSeries(CtVolume(test::smallCase().ct.geometry, 400), folder.toStdString(), {.seed = "dense"}));
  for (const QString& slice : QDir(folder).entryList(QDir::Files))
    test::editDicom(QDir(folder).filePath(slice).toStdString(),
                    [](gdcm::DataSet& data) { test::setText(data, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, "100"); });
  loader.open(folder);
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  auto* saturate = choice->findChild<QCheckBox*>("saturate");
  ASSERT_TRUE(waitUntil([&] { return saturate->isVisible(); }));
  EXPECT_TRUE(saturate->text().startsWith("Limit ")) << saturate->text().toStdString();
  EXPECT_TRUE(choice->findChild<QLabel*>("importNotes")->text().contains("exceed 32767 HU"));
  EXPECT_FALSE(button(choice, "Import")->isEnabled());
  saturate->click();
  EXPECT_TRUE(button(choice, "Import")->isEnabled());
  QTest::mouseClick(button(choice, "Import"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  ASSERT_TRUE(loaded) << failed.toStdString();
}

TEST_F(CaseLoader, ShowsWhatIsMadeAndWhatIsLeftOut) {
  const QString folder = writtenDicom("dicom");
  QFile stray(folder + "/notes.txt");
  ASSERT_TRUE(stray.open(QIODevice::WriteOnly));
  stray.close();
  loader.open(folder);
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  const QString notes = choice->findChild<QLabel*>("importNotes")->text();
  EXPECT_TRUE(notes.contains("49.0 x 41.0 x 17.0 mm, axes toward L, P, H, origin at -24.0, -6.0, -8.0 mm"))
      << notes.toStdString();
  auto* leftOut = choice->findChild<QPlainTextEdit*>("leftOut");
  EXPECT_TRUE(leftOut->isVisible());
  EXPECT_EQ(leftOut->toPlainText(), "notes.txt: neither DICOM nor a volume");
  EXPECT_TRUE(leftOut->focusPolicy() & Qt::TabFocus);
  choice->reject();
}

TEST_F(CaseLoader, KeepsWhatTheImportSaidInTheCase) {
  const QString folder = writtenDicom("dicom");
  const QStringList slices = QDir(folder).entryList(QDir::Files, QDir::Name);
  ASSERT_TRUE(QFile::remove(QDir(folder).filePath(slices[8])));
  loader.open(folder);
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  QTest::mouseClick(button(choice, "Import"), Qt::LeftButton);
  ASSERT_TRUE(waitUntil([this] { return ended(); }));
  ASSERT_TRUE(loaded) << failed.toStdString();
  ASSERT_FALSE(loaded->notes.isEmpty());
  loader.save(loaded->patient, home.filePath("kept"));
  ASSERT_TRUE(waitUntil([this] { return !saved.isEmpty() || !failed.isEmpty(); }));
  const auto kept = readCase(saved.toStdString());
  ASSERT_TRUE(kept) << kept.error().message;
  QStringList notes;
  for (const std::string& note : kept->patient.manifest.importNotes) notes << QString::fromStdString(note);
  EXPECT_EQ(notes, loaded->notes);
}

TEST_F(CaseLoader, ProposesTheCtWithMostSlices) {
  const QString folder = writtenDicom("mixed");
  VolumeGeometry fewer = test::smallCase().ct.geometry;
  fewer.size[2] = 5;
  ASSERT_TRUE(writeDicomSeries(CtVolume(fewer, 0), (folder + "/fewer").toStdString(), {.seed = "fewer"}));
  loader.open(folder);
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  auto* table = choice->findChild<QTableWidget*>();
  ASSERT_EQ(table->rowCount(), 2);
  EXPECT_EQ(table->item(table->currentRow(), 1)->text(), "49 x 41 x 17");
}

TEST_F(CaseLoader, WhatIsNotedIsReadWholeBesideALongName) {
  const QString folder = writtenDicom("mixed");
  test::writtenSmallCase(home, "mixed/anatomy-as-its-author-named-it");
  loader.open(folder);
  QDialog* choice = dialog();
  ASSERT_TRUE(choice) << failed.toStdString();
  choice->resize(880, 480);
  auto* table = choice->findChild<QTableWidget*>();
  EXPECT_GT(table->rowCount(), 1);
  const int notes = table->columnCount() - 1;
  const auto fits = [&] {
    return table->columnViewportPosition(notes) + table->columnWidth(notes) <= table->viewport()->width();
  };
  EXPECT_TRUE(waitUntil([&] { return table->width() < 650 && fits(); }, 5000))
      << table->columnViewportPosition(notes) << " + " << table->columnWidth(notes) << " of "
      << table->viewport()->width();
}

TEST_F(CaseLoader, TheChoiceMayBeRefused) {
  loader.open(writtenDicom("dicom"));
  QDialog* choice = dialog();
  ASSERT_TRUE(choice);
  QTest::keyClick(choice, Qt::Key_Escape);
  EXPECT_EQ(cancelled, 1);
  EXPECT_FALSE(loaded);
}

TEST_F(CaseLoader, TheLaterOfTwoOpensCounts) {
  const QString first = test::writtenSmallCase(home, "first"), second = test::writtenSmallCase(home, "second");
  loader.open(first);
  loader.open(second);
  ASSERT_TRUE(waitUntil([this] { return loaded.has_value(); }));
  EXPECT_EQ(cancelled, 1);
  EXPECT_EQ(loaded->folder, QDir(second).absolutePath());
}

TEST_F(CaseLoader, CancelsTheBuiltInNeckWithinASecond) {
  loader.openBuiltIn("textbook");
  QTest::qWait(200);
  ASSERT_TRUE(tasks.isRunning());
  tasks.cancel();
  EXPECT_EQ(cancelled, 1);
  EXPECT_TRUE(ui::waitForJobs(std::chrono::milliseconds(1000)));
}

TEST(SeriesDialog, SummarizesManySingleSlices) {
  auto listing = std::make_shared<SeriesListing>();
  for (int n = 0; n < 275; ++n) {
    SeriesInfo part{"1.2#" + std::to_string(n), "MR", {}, {}, true, {}, "It is MR, not CT."};
    part.geometry.size = {512, 512, n == 200 ? 30 : 1};
    listing->series.push_back(part);
  }
  ui::SeriesDialog dialog("neck", listing, nullptr);
  auto* table = dialog.findChild<QTableWidget*>();
  EXPECT_EQ(table->rowCount(), 3);
  EXPECT_EQ(table->currentRow(), 2);
  EXPECT_EQ(dialog.choice().uid, "1.2#200");
  EXPECT_TRUE(dialog.findChild<QLabel*>("omitted")->text().startsWith("272 more single slices (MR)"));
}

TEST(SeriesDialog, NamesTheKernelsThatTellReconstructionsApart) {
  auto listing = std::make_shared<SeriesListing>();
  for (const char* kernel : {"B30f", "B70f"}) {
    SeriesInfo series;
    series.uid = "1.2.840.113619.2.55.3.2831184641.5";
    series.modality = "CT";
    series.kernel = kernel;
    series.geometry.size = {512, 512, 300};
    listing->series.push_back(series);
  }
  listing->series[0].description = "Neck 1.0 soft", listing->series[0].date = "2026-11-24";
  ui::SeriesDialog dialog("neck", listing, nullptr);
  dialog.show();
  const auto* table = dialog.findChild<QTableWidget*>();
  EXPECT_EQ(table->item(0, 4)->text(), "Neck 1.0 soft");
  EXPECT_EQ(table->item(0, 5)->text(), "2026-11-24");
  EXPECT_FALSE(table->isColumnHidden(4) || table->isColumnHidden(5));
  EXPECT_TRUE(table->isColumnHidden(6)) << "no series states its body part";
  ASSERT_FALSE(table->isColumnHidden(3));
  EXPECT_EQ(table->horizontalHeaderItem(3)->text(), "Kernel");
  EXPECT_EQ(table->item(0, 3)->text(), "B30f");
  EXPECT_EQ(table->item(1, 3)->text(), "B70f");
}

}  // namespace
