#include "PrepareWindow.h"

#include <insonate/cases/CaseVersions.h>

#include <QAbstractItemDelegate>
#include <QMenu>
#include <QTabBar>

namespace insonate::prepare {
namespace {

constexpr int kIcon_px = 16, kPadding_px = 16;

/// The author's terms of labels: names, tissues and states, in the table and below it.
class LabelTable : public PrepareWindow {
 protected:
  static constexpr std::uint8_t kOwn = kLabelCount;

  QString cell(std::uint8_t label, int column, int role = Qt::DisplayRole) {
    return table()->model()->index(rowOf(label), column).data(role).toString();
  }
  void choose(const char* box, int row) {
    auto* combo = child<QComboBox>(box);
    ASSERT_TRUE(combo->isEnabled());
    combo->setCurrentIndex(row);
    Q_EMIT combo->activated(row);
  }
  void addOwn() {
    auto* menu = child<QPushButton>("addLabel")->menu();
    Q_EMIT menu->aboutToShow();
    ASSERT_TRUE(menu->actions().back()->text().contains("Another structure"));
    menu->actions().back()->trigger();
  }
  /// Typed into the cell that is being edited.
  void type(const QString& name) {
    auto* line = table()->viewport()->findChild<QLineEdit*>();
    ASSERT_TRUE(line);
    line->setText(name);
    QTest::keyClick(line, Qt::Key_Return);
    QApplication::processEvents();
  }
  PatientCase saved() {
    PatientCase copy = *shared_->openCase.patient();
    if (const ui::CaseEdit edit = workspace_->unsavedEdit()) edit(copy);
    return copy;
  }
};

TEST_F(LabelTable, AStructureOfOnesOwnIsNamedAtOnceAndCanBeTakenBack) {
  openCase();
  const std::size_t before = shared_->structures.labels().size();
  addOwn();
  EXPECT_EQ(shared_->structures.selected(), kOwn);
  type("left  external\njugular");
  EXPECT_EQ(cell(kOwn, kName), "left external jugular");
  EXPECT_EQ(shared_->terms.stateOf(kOwn), LabelState::NotStarted);
  EXPECT_EQ(saved().manifest.ownLabels, (OwnLabels{{kOwn, {"left external jugular", kSoftTissue}}}));
  child<QAction>("undo")->trigger();
  EXPECT_EQ(cell(kOwn, kName), "label 16");
  child<QAction>("undo")->trigger();
  EXPECT_EQ(shared_->structures.labels().size(), before);
  EXPECT_FALSE(workspace_->unsavedEdit());
  child<QAction>("redo")->trigger();
  child<QAction>("redo")->trigger();
  EXPECT_EQ(cell(kOwn, kName), "left external jugular");
}

TEST_F(LabelTable, WhoChoseTheTableWhileItIsMeasuredStaysThere) {
  PatientCase bare = test::smallCase();
  std::ranges::replace(bare.labels.voxels, std::uint8_t{kVein}, std::uint8_t{kSoftTissue});
  const auto without = std::make_shared<const PatientCase>(std::move(bare));
  auto* tabs = child<QTabBar>("labelling");
  openCase(without);
  ASSERT_EQ(tabs->currentIndex(), 0) << "a neck without a vein is to be labelled: the guide comes";
  workspace_->setCase(without);
  QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(1).center());
  ASSERT_TRUE(QTest::qWaitFor([&] { return workspace_->isReady(); }, kPatience_ms));
  EXPECT_EQ(tabs->currentIndex(), 1);
}

TEST_F(LabelTable, ATissueIsChosenForOnesOwnOnly) {
  openCase();
  shared_->structures.select(kVein);
  EXPECT_FALSE(child<QComboBox>("labelTissue")->isEnabled());
  EXPECT_EQ(child<QComboBox>("labelTissue")->currentText(), "vein");
  EXPECT_TRUE(child<QLabel>("labelTerm")->text().startsWith("SNOMED CT 29092000, Vein;"));
  shared_->structures.add(kOwn);
  choose("labelTissue", child<QComboBox>("labelTissue")->findText("bone"));
  EXPECT_EQ(saved().manifest.ownLabels.at(kOwn).tissue, kBone);
  EXPECT_EQ(cell(kOwn, kTissue), "bone");
  EXPECT_TRUE(child<QLabel>("labelTerm")->text().startsWith("SNOMED CT 272673000, Bone;"));
  EXPECT_NE(contentHashOf(saved()), "") << "and is part of what trainees get";
  child<QAction>("undo")->trigger();
  EXPECT_EQ(child<QComboBox>("labelTissue")->currentText(), "soft tissue");
}

TEST_F(LabelTable, StatesAreChangedByClickKeyAndChoice) {
  openCase();
  EXPECT_EQ(shared_->terms.stateOf(kVein), LabelState::InProgress) << "nobody has said so, but it is begun";
  EXPECT_FALSE(workspace_->unsavedEdit());
  clickCell(kVein, kState);
  EXPECT_EQ(shared_->terms.stateOf(kVein), LabelState::Completed);
  EXPECT_EQ(cell(kVein, kState, Qt::AccessibleTextRole), "vein: completed") << "a word beside the glyph";
  EXPECT_TRUE(workspace_->statusText().contains("vein: completed"));
  key(Qt::Key_S);
  EXPECT_EQ(child<QComboBox>("labelState")->currentText(), "flagged");
  choose("labelState", 0);
  EXPECT_EQ(saved().manifest.states, (LabelStates{{kVein, LabelState::NotStarted}}));
  for (int n = 0; n < 3; ++n) child<QAction>("undo")->trigger();
  EXPECT_EQ(shared_->terms.stateOf(kVein), LabelState::InProgress);
  EXPECT_FALSE(workspace_->unsavedEdit());
}

TEST_F(LabelTable, HostileNamesDoNoHarm) {
  openCase();
  shared_->structures.add(kOwn);
  shared_->terms.setName(kOwn, QString(10'000, QLatin1Char('x')));
  EXPECT_EQ(cell(kOwn, kName).size(), 64);
  shared_->terms.setName(kOwn, "<img src='x'><b>a</b>\n\"\\");
  EXPECT_EQ(cell(kOwn, kName), "<img src='x'><b>a</b> '/");
  shared_->terms.setName(kOwn, "vein");
  EXPECT_EQ(cell(kOwn, kName), "<img src='x'><b>a</b> '/") << "two of one name";
  EXPECT_TRUE(workspace_->statusText().contains("named vein already")) << workspace_->statusText().toStdString();
  shared_->terms.setName(kVein, "artery");
  EXPECT_EQ(cell(kVein, kName), "vein") << "the label table's names stay";
}

TEST_F(LabelTable, AWideTableShowsTissueTermAndVoxels) {
  openCase();
  EXPECT_TRUE(table()->isColumnHidden(kTissue));
  EXPECT_EQ(cell(kVein, kState), "") << "no room for the word beside the glyph";
  table()->parentWidget()->setFixedWidth(900);
  ASSERT_TRUE(QTest::qWaitFor([&] { return !table()->isColumnHidden(kTissue); }, kPatience_ms));
  EXPECT_EQ(cell(kVein, kState), "in progress");
  EXPECT_EQ(cell(kVein, kTissue + 1), "SNOMED CT 29092000, Vein");
  EXPECT_FALSE(table()->isColumnHidden(kTissue + 2));
  for (const char* word : {"not started", "in progress", "completed"})
    EXPECT_LE(table()->fontMetrics().horizontalAdvance(word) + kIcon_px + kPadding_px, table()->columnWidth(kState))
        << word;
  EXPECT_LE(table()->fontMetrics().horizontalAdvance("12,345,678") + kPadding_px, table()->columnWidth(kTissue + 2));
}

TEST_F(LabelTable, ValuesOfEditedLabelsAreMarkedUntilTheyAreMeasuredAgain) {
  openCase();
  const QString before = cell(kVein, kVolume), bone = cell(kBone, kVolume);
  const auto color = [this] { return table()->model()->index(rowOf(kVein), kVolume).data(Qt::ForegroundRole); };
  LabelStep step;
  step.tool = step::Paint{.radius_mm = 3};
  step.label = kVein;
  ASSERT_TRUE(shared_->labeling.beginStroke(step, "paint"));
  shared_->labeling.strokeTo({15, 12, 0});
  EXPECT_EQ(cell(kVein, kVolume), QChar(0x2026) + before) << "marked from the first change of the stroke on";
  shared_->labeling.endStroke();
  EXPECT_LE(table()->fontMetrics().horizontalAdvance(QString(QChar(0x2026)) + "12.34") + kPadding_px,
            table()->columnWidth(kVolume))
      << "not elided";
  EXPECT_EQ(cell(kVein, kVolume, Qt::ToolTipRole),
            "Volume of vein in milliliters before its last change; not measured since");
  EXPECT_TRUE(cell(kVein, kVolume, Qt::AccessibleTextRole).endsWith(", before the last change"));
  EXPECT_TRUE(color().isValid()) << "quiet, too";
  EXPECT_TRUE(cell(kSoftTissue, kVolume).startsWith(QChar(0x2026))) << "the stroke has taken voxels from it";
  EXPECT_EQ(cell(kBone, kVolume), bone);
  shared_->structures.select(kVein);
  EXPECT_TRUE(child<QLabel>("labelTerm")->text().endsWith("voxels before the last change"));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !shared_->measuring.isOutdated(kVein); }, kPatience_ms));
  EXPECT_GT(cell(kVein, kVolume).toDouble(), before.toDouble());
  EXPECT_EQ(cell(kVein, kVolume, Qt::ToolTipRole), "Volume of vein in milliliters");
  EXPECT_FALSE(color().isValid());
  EXPECT_FALSE(child<QLabel>("labelTerm")->text().contains("before"));
}

TEST_F(LabelTable, ClearForgetsOneOfOnesOwnThatHasNoVoxels) {
  openCase();
  shared_->structures.add(kOwn);
  child<QPushButton>("clearLabel")->click();
  EXPECT_TRUE(shared_->terms.value().own.empty());
  EXPECT_NE(shared_->structures.selected(), kOwn);
  child<QAction>("undo")->trigger();
  EXPECT_TRUE(shared_->terms.value().own.contains(kOwn));
}

}  // namespace
}  // namespace insonate::prepare
