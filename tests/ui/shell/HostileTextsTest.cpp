#include "AccountWindow.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/PlainToolTip.h>

#include <support/SmallCase.h>
#include <ui/support/PlainTexts.h>

#include <QListWidget>
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
