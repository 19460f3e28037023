#include "AccountWindow.h"
#include "cases/SeriesDialog.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/RecentCases.h>

#include <support/SmallCase.h>
#include <ui/support/PlainTexts.h>

#include <QDir>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QToolTip>

namespace {

using namespace insonate;
using test::waitUntil;

/// An administrator, a class, a curriculum and a case, all called what no one should be called.
class HostileTexts : public test::AccountWindow {
 protected:
  void SetUp() override {
    AccountWindow::SetUp();
    setUp();
    const auto made = asked<int>([](const SignedIn& by) -> Result<int> {
      const std::string name = test::kHostileText.toStdString();
      const auto cohort = CohortStore(by).add(name);
      if (!cohort) return tl::unexpected(cohort.error());
      const auto person = PeopleStore(by).add({"x", name, "", Role::Trainee}, "12345678", cohort->id);
      if (!person) return tl::unexpected(person.error());
      Curriculum curriculum = *loadCurriculum("central_line");
      curriculum.name = "hostile", curriculum.title = curriculum.about = test::endlessText().toStdString();
      for (Level& level : curriculum.levels) level.title = level.about = curriculum.title;
      const auto published = PublishedCurricula(by).publish("hostile", curriculum.version, curriculumText(curriculum));
      if (!published) return tl::unexpected(published.error());
      return CohortStore(by).setCurriculum(cohort->id, "hostile", curriculum.version).map([] { return 0; });
    });
    ASSERT_TRUE(made) << made.error().message;
  }
};

TEST_F(HostileTexts, InPeopleAndClassesAreTexts) {
  ASSERT_TRUE(asked<int>([](const SignedIn& by) {
    return PeopleStore(by).changeOwnDetails(test::kHostileText.toStdString(), "").map([] { return 0; });
  }));
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  ASSERT_TRUE(waitUntil([&] { return classes->count() == 2; }));
  classes->setCurrentRow(1);
  auto* table = people->findChild<QTableWidget*>("peopleTable");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 1; }));
  EXPECT_EQ(row(*table, 0)[0], test::kHostileText);
  test::expectPlain(*people);
  people->findChild<QPushButton*>("peopleImport")->click();
  QDialog* list = dialogWith("listTable");
  EXPECT_GE(test::expectPlain(*list), 1) << "it names the class";
  EXPECT_LE(window->minimumSizeHint().width(), 1366);
}

TEST_F(HostileTexts, InCurriculaAreTexts) {
  action("accountLevels").trigger();
  QDialog* dialog = dialogWith("curricula");
  auto* levels = dialog->findChild<QListWidget*>("curriculumLevels");
  ASSERT_TRUE(waitUntil([&] { return levels->count() > 0; }));
  test::expectPlain(*dialog);
}

TEST_F(HostileTexts, InTheTitleOfTheCaseAreTexts) {
  PatientCase patient = test::smallCase();
  patient.manifest.title = test::endlessText().toStdString();
  const QString folder = home.filePath("case");
  ASSERT_TRUE(saveCaseVersion(patient, folder.toStdString(), "2026-11-22", ""));
  window->open(folder);
  ASSERT_TRUE(waitUntil([&] { return window->caseTitle().contains("WWWW"); }));
  test::expectPlain(*window);
}

TEST_F(HostileTexts, InMenusMarkNoKeys) {
  const QString title = test::endlessText() + "\tCtrl+Q";
  ASSERT_TRUE(QDir(home.path()).mkdir("<b>bold"));
  ui::rememberCase({home.filePath("<b>bold"), title});
  ASSERT_TRUE(asked<int>(
      [](const SignedIn& by) { return PeopleStore(by).changeOwnDetails("A&da & &Co", "").map([] { return 0; }); }));
  signOut();
  signIn("ada", test::kAccountPassword);
  ASSERT_TRUE(waitUntil([&] { return header().contains("A&&da"); })) << header().toStdString();
  for (const auto* button : window->findChildren<QToolButton*>()) {
    if (button->accessibleName() != "Account menu") continue;
    EXPECT_EQ(button->shortcut(), QKeySequence("Alt+U"));
  }
  int seen = 0;
  for (QMenu* menu : window->findChildren<QMenu*>()) {
    Q_EMIT menu->aboutToShow();
    for (const QAction* entry : menu->actions()) {
      if (!entry->text().contains("da &&") && !entry->text().contains("<b>bold")) continue;
      ++seen;
      EXPECT_FALSE(QString(entry->text()).remove("&&").contains('&')) << entry->text().toStdString();
      EXPECT_FALSE(entry->text().contains('\t')) << "what follows it stands where keys do";
      EXPECT_LE(menu->sizeHint().width(), 1366);
    }
  }
  EXPECT_EQ(seen, 2) << "who is signed in, and the recent case";
}

TEST_F(HostileTexts, InTheImportOfASeriesAreTexts) {
  const std::string hostile = test::kHostileText.toStdString(), endless = test::endlessText().toStdString();
  const std::string zero = hostile + std::string(1, '\0') + "after";
  auto listing = std::make_shared<SeriesListing>();
  for (const std::string& one : {hostile, endless, zero}) {
    SeriesInfo series;
    series.uid = series.modality = series.kernel = series.refusal = one;
    series.warnings = {one, one};
    listing->series.push_back(series);
  }
  listing->skippedFiles.push_back({hostile + "/x.dcm", endless});
  const QString folder = QDir(home.path()).filePath("<b>bold &File " + QString(230, 'W'));
  ui::SeriesDialog dialog(folder, listing, window.get());
  dialog.show();
  auto* table = dialog.findChild<QTableWidget*>();
  for (int row = 0; row < table->rowCount(); ++row) {
    table->selectRow(row);
    EXPECT_GE(test::expectPlain(dialog), 2) << "the folder's name, and what is noted";
    for (const QString& line : table->item(row, 0)->toolTip().split('\n')) EXPECT_LE(line.size(), 100);
  }
}

TEST_F(HostileTexts, InMessagesAndTooltipsAreTexts) {
  QMessageBox box(QMessageBox::Question, "Title", test::kHostileText, QMessageBox::Ok, window.get());
  box.show();
  EXPECT_GE(test::expectPlain(box), 1);
  QToolTip::showText(window->mapToGlobal({50, 50}), ui::plainToolTip(test::endlessText()), window.get());
  const QLabel* tip = nullptr;
  for (const QWidget* top : QApplication::topLevelWidgets())
    if (top->inherits("QTipLabel")) tip = qobject_cast<const QLabel*>(top);
  ASSERT_TRUE(tip);
  EXPECT_EQ(tip->textFormat(), Qt::PlainText);
  EXPECT_LE(tip->width(), 1366) << "it is wrapped";
  EXPECT_LE(tip->height(), 768) << "and cut";
}

TEST(PlainCaption, IsOneLineWithoutKeys) {
  EXPECT_EQ(ui::plainCaption("A & B\tC\nD"), "A && B C D");
  EXPECT_EQ(ui::plainCaption(QString(200, 'x')), QString(90, 'x') + " ...");
}

TEST(PlainToolTip, WrapsAtSpacesAndKeepsLines) {
  EXPECT_EQ(ui::plainToolTip({}), QString());
  EXPECT_EQ(ui::plainToolTip("one\ntwo"), "one\ntwo");
  const QString words = QStringLiteral("word ").repeated(40).trimmed();
  const QStringList lines = ui::plainToolTip(words).split('\n');
  EXPECT_EQ(lines.size(), 3);
  EXPECT_EQ(lines.join(' '), words);
  EXPECT_EQ(ui::plainToolTip(QString(200, 'x')).split('\n').size(), 3);
}

}  // namespace
