#include "Waiting.h"
#include "cases/CaseExchange.h"
#include "cases/CropDialog.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/EmptyWorkspace.h>
#include <insonate/ui/ErrorPanel.h>
#include <insonate/ui/MainWindow.h>
#include <insonate/ui/TaskBar.h>

#include <gtest/gtest.h>
#include <support/SmallCase.h>

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QThread>
#include <QTimer>
#include <QtTest/QTest>
#include <algorithm>
#include <cmath>

namespace {

using namespace insonate;
using test::waitUntil;

void writeFile(const QString& file, const QByteArray& bytes) {
  QFile stream(file);
  ASSERT_TRUE(stream.open(QFile::WriteOnly) && stream.write(bytes) == bytes.size());
}

/// A label map as any program might write it: numbers without names.
void writeNrrd(const LabelMap& labels, const QString& file) {
  const VolumeGeometry& g = labels.geometry;
  const auto triple = [](Vec3 v) { return QStringLiteral("(%1,%2,%3)").arg(v.x).arg(v.y).arg(v.z); };
  QString directions;
  for (int a = 0; a < 3; ++a) directions += " " + triple(g.direction.column[a] * g.spacing_mm[a]);
  const QString header = QStringLiteral(
                             "NRRD0004\ntype: unsigned char\ndimension: 3\nsizes: %1 %2 %3\nspace: "
                             "left-posterior-superior\nspace directions:%4\nspace origin: %5\nencoding: raw\n\n")
                             .arg(g.size[0])
                             .arg(g.size[1])
                             .arg(g.size[2])
                             .arg(directions, triple(g.origin_mm));
  const auto* bytes = reinterpret_cast<const char*>(labels.voxels.data());
  writeFile(file, header.toLatin1() + QByteArray(bytes, int(labels.voxels.size())));
}

/// The window with a small case, its menu, and a folder for what goes out.
class CaseExchange : public testing::Test {
 protected:
  CaseExchange() {
    window.show();
    window.open(test::writtenSmallCase(home, "block"));
    EXPECT_TRUE(waitUntil([this] { return action("cropCase")->isEnabled(); }));
  }
  ~CaseExchange() override { window.closeAtOnce(); }
  QAction* action(const char* name) { return window.findChild<QAction*>(name); }
  bool idle() { return action("cropCase")->isEnabled(); }
  void exportTo(const char* way, const QString& target, const QString& written) {
    test::answerFileDialog(window, target);
    action(way)->trigger();
    EXPECT_TRUE(waitUntil([&] { return QFile::exists(written) && idle(); })) << way;
  }
  /// The dialog that shows how labels are understood; null if there is none.
  QDialog* labelsDialog() {
    for (auto* dialog : window.findChildren<QDialog*>())
      if (dialog->isVisible() && dialog->findChild<QTableWidget*>("labelMapping")) return dialog;
    return nullptr;
  }
  QDialog* readLabels(const QString& file) {
    test::answerFileDialog(window, file);
    action("importLabels")->trigger();
    EXPECT_TRUE(waitUntil([this] { return labelsDialog() != nullptr; }));
    return labelsDialog();
  }

  QTemporaryDir home;
  ui::MainWindow window;
};

TEST_F(CaseExchange, ACaseGoesOutInEveryWay) {
  exportTo("exportDicom", home.filePath("series"), home.filePath("series/slice00017.dcm"));
  exportTo("exportSeg", home.filePath("labels"), home.filePath("labels.dcm"));
  exportTo("exportLabels", home.filePath("labels"), home.filePath("labels.seg.nrrd"));
  EXPECT_TRUE(QFile::exists(home.filePath("labels.label.txt")));
  exportTo("exportStl", home.filePath("stl"), home.filePath("stl/vein.stl"));
  exportTo("exportVtp", home.filePath("vtp"), home.filePath("vtp/vein.vtp"));
  EXPECT_TRUE(window.statusText().isEmpty() || !window.errors().isVisible());
}

TEST_F(CaseExchange, WhatCannotBeWrittenIsSaid) {
  test::answerFileDialog(window, home.filePath("missing/stl"));
  action("exportStl")->trigger();
  EXPECT_TRUE(waitUntil([this] { return window.errors().isVisible(); }));
  EXPECT_FALSE(QFile::exists(home.filePath("missing")));
}

TEST_F(CaseExchange, ACaseWithImportedLabelsKeepsItsFolder) {
  PatientCase other = test::smallCase();
  for (std::uint8_t& label : other.labels.voxels)
    if (label == kVein) label = kArtery;
  const QString file = home.filePath("other.dcm");
  ASSERT_TRUE(writeDicomSegmentation(other, file.toStdString()));
  const auto before = window.current().patient;
  QDialog* dialog = readLabels(file);
  const auto* mapping = dialog->findChild<QTableWidget*>("labelMapping");
  ASSERT_GT(mapping->rowCount(), 0);
  EXPECT_EQ(window.current().patient, before) << "nothing is replaced before the user has seen it";
  EXPECT_FALSE(dialog->findChild<QLabel*>("labelPreview")->pixmap(Qt::ReturnByValue).isNull());
  dialog->findChild<QPushButton*>("replaceLabels")->click();
  ASSERT_TRUE(waitUntil([&] { return window.current().patient != before; }));
  EXPECT_EQ(window.current().patient->labels.voxels, other.labels.voxels);
  const QString folder = window.current().folder;
  EXPECT_TRUE(folder.endsWith("block")) << folder.toStdString();
  EXPECT_EQ(readCase(folder.toStdString())->patient.labels.voxels, before->labels.voxels) << "until it is saved";
  EXPECT_TRUE(window.commands().action("window.case.save")->isEnabled());

  EXPECT_TRUE(waitUntil([this] { return idle(); }));
  ASSERT_TRUE(action("undoImportLabels")->isEnabled());
  const auto imported = window.current().patient;
  action("undoImportLabels")->trigger();
  ASSERT_TRUE(waitUntil([&] { return window.current().patient != imported && idle(); }));
  EXPECT_EQ(window.current().patient->labels.voxels, before->labels.voxels);
  EXPECT_EQ(window.current().patient->ct.voxels, before->ct.voxels);
  EXPECT_EQ(window.current().folder, folder);
  EXPECT_FALSE(action("undoImportLabels")->isEnabled());

  readLabels(file)->findChild<QPushButton*>("replaceLabels")->click();
  ASSERT_TRUE(waitUntil([&] { return window.current().patient->labels.voxels == other.labels.voxels && idle(); }));
  window.saveCase();
  ASSERT_TRUE(waitUntil([&] { return !window.commands().action("window.case.save")->isEnabled() && idle(); }));
  EXPECT_EQ(readCase(folder.toStdString())->patient.labels.voxels, other.labels.voxels);
  EXPECT_EQ(window.current().folder, folder);
}

TEST_F(CaseExchange, AMaskWithADoubtfulSideIsAsked) {
  const PatientCase patient = test::smallCase();
  LabelMap mask(patient.labels.geometry);
  for (std::size_t v = 0; v < mask.voxels.size(); ++v) mask.voxels[v] = patient.labels.voxels[v] == kVein;
  QDir(home.path()).mkdir("masks");
  writeNrrd(mask, home.filePath("masks/internal_jugular_vein.nrrd"));
  writeNrrd(mask, home.filePath("masks/spleen.nrrd"));
  QTimer choosing;
  QObject::connect(&choosing, &QTimer::timeout, &window, [this, &choosing] {
    auto* files = window.findChild<QFileDialog*>();
    if (!files || !files->isVisible()) return;
    choosing.stop();
    files->setDirectory(home.filePath("masks"));
    files->findChild<QPushButton*>("importFolder")->click();
  });
  choosing.start(20);
  action("importLabels")->trigger();
  ASSERT_TRUE(waitUntil([this] { return labelsDialog() != nullptr; }));
  auto* dialog = labelsDialog();
  auto* table = dialog->findChild<QTableWidget*>("labelMapping");
  ASSERT_EQ(table->rowCount(), 2);
  auto* replace = dialog->findChild<QPushButton*>("replaceLabels");
  auto* side = table->findChild<QComboBox*>();
  ASSERT_TRUE(side);
  EXPECT_EQ(side->currentText(), "?") << "the vein lies in the middle of the block";
  EXPECT_FALSE(replace->isEnabled());
  side->setCurrentText("right");
  EXPECT_TRUE(replace->isEnabled());
  EXPECT_EQ(table->item(1, 0)->checkState(), Qt::Unchecked) << "no label has the tissue of a spleen";
  dialog->findChild<QCheckBox*>("labelRest")->setChecked(false);
  const auto before = window.current().patient;
  replace->click();
  ASSERT_TRUE(waitUntil([&] { return window.current().patient != before; }));
  EXPECT_EQ(std::ranges::count(window.current().patient->labels.voxels, kVein), std::ranges::count(mask.voxels, 1));
  const auto& vessels = window.current().patient->manifest.vessels;
  EXPECT_NE(std::ranges::find(vessels, "right internal jugular vein", &NamedVessel::name), vessels.end());
}

TEST_F(CaseExchange, NumbersOfAnotherProgramAreNotTakenUnasked) {
  const PatientCase other = test::smallCase();
  const QString file = home.filePath("map.nrrd");
  writeNrrd(other.labels, file);
  const auto before = window.current().patient;
  QDialog* dialog = readLabels(file);
  auto* replace = dialog->findChild<QPushButton*>("replaceLabels");
  EXPECT_FALSE(replace->isEnabled()) << "1 is skin here and may be anything there";
  auto* ours = dialog->findChild<QCheckBox*>("numbersAreOurs");
  ASSERT_TRUE(ours);
  ours->setChecked(true);
  EXPECT_TRUE(replace->isEnabled());
  dialog->reject();
  EXPECT_EQ(window.current().patient, before);

  const QString names = home.filePath("names.json");
  writeFile(names, R"({"labels": {"artery": )" + QByteArray::number(kVein) + "}}");
  dialog = readLabels(file);
  test::answerFileDialog(window, names);
  dialog->findChild<QPushButton*>("nameNumbers")->click();
  ASSERT_TRUE(waitUntil([&] { return labelsDialog() && !labelsDialog()->findChild<QCheckBox*>("numbersAreOurs"); }));
  labelsDialog()->findChild<QCheckBox*>("labelRest")->setChecked(false);
  labelsDialog()->findChild<QPushButton*>("replaceLabels")->click();
  ASSERT_TRUE(waitUntil([&] { return window.current().patient != before; }));
  const auto& labels = window.current().patient->labels.voxels;
  for (std::size_t v = 0; v < labels.size(); ++v)
    ASSERT_EQ(labels[v], other.labels.voxels[v] == kVein ? kArtery : kBackground);
}

TEST_F(CaseExchange, APartIsCroppedAndResampled) {
  action("cropCase")->trigger();
  ASSERT_TRUE(waitUntil([this] { return window.findChild<QDialog*>() != nullptr; }));
  auto* dialog = window.findChild<QDialog*>();
  const auto field = [&](const QString& name) {
    for (auto* box : dialog->findChildren<QDoubleSpinBox*>())
      if (box->accessibleName() == name) return box;
    return static_cast<QDoubleSpinBox*>(nullptr);
  };
  for (auto* box : dialog->findChildren<QDoubleSpinBox*>()) EXPECT_FALSE(box->toolTip().isEmpty());
  const auto labels = dialog->findChildren<QLabel*>();
  for (const char* axis : {"right to left", "front to back", "feet to head"})
    EXPECT_TRUE(std::ranges::any_of(labels, [&](const QLabel* label) {
      return label->isVisible() && label->buddy() == field(QString("Spacing, %1").arg(axis));
    })) << axis;
  QPushButton* crop = nullptr;
  for (auto* button : dialog->findChildren<QPushButton*>())
    if (button->text().remove('&') == "Crop") crop = button;
  ASSERT_TRUE(crop);
  const auto* result = dialog->findChild<QLabel*>("cropResult");
  EXPECT_TRUE(result->text().contains("Size now: 49 x 41 x 17")) << result->text().toStdString();
  field("From, right to left")->setValue(-10);
  field("To, right to left")->setValue(-10.5);
  EXPECT_TRUE(crop->isEnabled()) << "either corner may come first";
  field("To, right to left")->setValue(10);
  dialog->findChild<QCheckBox*>()->setChecked(true);
  for (const char* axis : {"right to left", "front to back", "feet to head"})
    field(QString("Spacing, %1").arg(axis))->setValue(0.5);
  EXPECT_TRUE(result->text().contains("new case: 42 x 82 x 34 voxels")) << result->text().toStdString();
  const auto before = window.current().patient;
  QTest::mouseClick(crop, Qt::LeftButton);
  ASSERT_TRUE(waitUntil([&] { return window.current().patient != before; }));
  EXPECT_EQ(window.current().patient->ct.geometry.size, (std::array{42, 82, 34}));
  EXPECT_EQ(window.current().patient->manifest.targets.size(), 1U);
  EXPECT_TRUE(window.current().folder.isEmpty());
}

TEST_F(CaseExchange, WhatIsGrayDuringAJobSaysWhy) {
  EXPECT_FALSE(action("cropCase")->toolTip().contains("Wait"));
  ui::TaskBar& tasks = *window.findChild<ui::TaskBar*>("taskBar");
  const auto endless = [](const Progress& progress) -> Result<int> {
    while (report(progress, "importing", 0.25)) QThread::msleep(5);
    return fail(std::string(kCancelled));
  };
  tasks.run<int>("Importing neck", endless, [](Result<int>) {});
  EXPECT_FALSE(action("cropCase")->isEnabled());
  EXPECT_TRUE(action("cropCase")->toolTip().contains("Wait until \"Importing neck\" has ended."));
  tasks.cancel();
  EXPECT_TRUE(action("cropCase")->isEnabled());
  EXPECT_FALSE(action("cropCase")->toolTip().contains("Wait"));
  tasks.run<int>(
      "Checking", endless, [](Result<int>) {}, ui::TaskBar::WhenClosed::Stop, ui::TaskBar::StartedBy::Program);
  EXPECT_TRUE(action("cropCase")->isEnabled()) << "a check gives way";
  tasks.cancel();
}

TEST_F(CaseExchange, OnlyTheAxisWhoseSpacingIsChangedIsResampled) {
  const auto patient = std::make_shared<PatientCase>(*window.current().patient);
  patient->ct.geometry.spacing_mm = {0.9765625, 0.9765625, 4.25};
  const ui::CropDialog dialog(patient, &window);
  dialog.findChild<QCheckBox*>()->setChecked(true);
  for (auto* box : dialog.findChildren<QDoubleSpinBox*>())
    if (box->accessibleName() == "Spacing, feet to head") box->setValue(1);
  EXPECT_EQ(dialog.options().spacing_mm, (Vec3{0.9765625, 0.9765625, 1})) << "0.977 would blur what was not asked for";
}

void drag(QWidget& views, QPointF from, QPointF to) {
  const auto send = [&](QEvent::Type type, QPointF at, Qt::MouseButtons held) {
    QMouseEvent event(type, at, Qt::LeftButton, held, Qt::NoModifier);
    QCoreApplication::sendEvent(&views, &event);
  };
  send(QEvent::MouseButtonPress, from, Qt::LeftButton);
  send(QEvent::MouseMove, to, Qt::LeftButton);
  send(QEvent::MouseButtonRelease, to, Qt::NoButton);
}

/// The axial slice shows the patient's right on the left, the coronal one the head on top.
TEST_F(CaseExchange, ThePartIsDraggedInThreeSlices) {
  ui::CropDialog dialog(window.current().patient, &window);
  dialog.show();
  auto& views = *dialog.findChild<ui::CropViews*>();
  const auto value = [&dialog](const char* name) {
    for (auto* box : dialog.findChildren<QDoubleSpinBox*>())
      if (box->accessibleName() == name) return box->value();
    return std::nan("");
  };
  const ui::PatientBox all = views.box();
  const Vec3 middle_mm = (all.low_mm + all.high_mm) * 0.5;
  const auto at = [&](int view, int axis, double to_mm) {
    Vec3 place_mm = middle_mm;
    place_mm[axis] = to_mm;
    return views.placeOf(view, place_mm);
  };
  drag(views, at(0, 0, all.low_mm.x), at(0, 0, all.low_mm.x + 6));
  EXPECT_NEAR(value("From, right to left"), all.low_mm.x + 6, 0.06);
  drag(views, at(0, 1, all.high_mm.y), at(0, 1, all.high_mm.y - 5));
  EXPECT_NEAR(value("To, front to back"), all.high_mm.y - 5, 0.06);
  drag(views, at(1, 2, all.high_mm.z), at(1, 2, all.high_mm.z - 3));
  EXPECT_NEAR(value("To, feet to head"), all.high_mm.z - 3, 0.06);
  EXPECT_NEAR(value("From, feet to head"), all.low_mm.z, 0.06);

  drag(views, at(2, 1, middle_mm.y), at(2, 1, middle_mm.y + 500));
  EXPECT_NEAR(views.box().high_mm.y, all.high_mm.y, 0.06) << "the whole box moves up to the border";
  EXPECT_NEAR(views.box().low_mm.y, all.low_mm.y + 5, 0.06);
  drag(views, at(0, 0, views.box().low_mm.x), at(0, 0, all.high_mm.x + 500));
  EXPECT_NEAR(views.box().high_mm.x - views.box().low_mm.x, 10, 0.06) << "a border does not pass the other one";

  for (auto* box : dialog.findChildren<QDoubleSpinBox*>())
    if (box->accessibleName() == "From, right to left") box->setValue(all.low_mm.x + 1);
  EXPECT_NEAR(views.box().low_mm.x, all.low_mm.x + 1, 0.06) << "the slices follow the fields";
}

/// Labels outside of the part, or never saved, are not in it.
TEST_F(CaseExchange, APartTakesThePlaceOfWhatIsNotSavedOnlyWhenAllowed) {
  auto* exchange = window.findChild<ui::CaseExchange*>();
  const auto cropTo = [&](int size) {
    exchange->crop({{{0, 0, 0}, {size, size, size}}, {}});
    ASSERT_TRUE(waitUntil([this] { return !window.tasks().isRunning(); }));
  };
  const auto width = [this] { return window.current().patient->ct.geometry.size[0]; };
  cropTo(16);
  ASSERT_TRUE(waitUntil([&] { return width() == 16; })) << "all of the open case is on disk";
  for (const char* answer : {"keep", "goOn"}) {
    cropTo(8);
    ASSERT_TRUE(waitUntil([this] { return window.findChild<QDialog*>() != nullptr; })) << "the first part is nowhere";
    EXPECT_EQ(width(), 16);
    window.findChild<QDialog*>()->findChild<QPushButton*>(answer)->click();
    ASSERT_TRUE(waitUntil([this] { return window.findChild<QDialog*>() == nullptr; }));
  }
  EXPECT_TRUE(waitUntil([&] { return width() == 8; }));
}

TEST_F(CaseExchange, SpacingIsNamedByThePatientsDirectionsOnAnyGrid) {
  const auto names = [this](const std::array<Vec3, 3>& axes) {
    const auto patient = std::make_shared<PatientCase>(*window.current().patient);
    for (int a = 0; a < 3; ++a) patient->ct.geometry.direction.column[a] = axes[a];
    const ui::CropDialog dialog(patient, &window);
    QStringList found;
    for (const auto* box : dialog.findChildren<QDoubleSpinBox*>())
      if (box->accessibleName().startsWith("Spacing")) found << box->accessibleName();
    return found;
  };
  EXPECT_EQ(names({Vec3{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}}),
            QStringList({"Spacing, feet to head", "Spacing, right to left", "Spacing, front to back"}));
  const double turned = std::sqrt(0.5);
  EXPECT_EQ(names({Vec3{turned, turned, 0}, {-turned, turned, 0}, {0, 0, 1}}),
            QStringList({"Spacing, RA to LP", "Spacing, LA to RP", "Spacing, feet to head"}));
}

}  // namespace
