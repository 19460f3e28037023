#include "AccountWindow.h"
#include "account/ClassListDialog.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/ui/Commands.h>

#include <QComboBox>
#include <QFile>
#include <QListWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>

namespace {

using namespace insonate;
using test::waitUntil;

/// Classes "Mine" and "Other" with an instructor each, ivy and oz, and a trainee each, tim and una.
class Roles : public test::AccountWindow {
 protected:
  void SetUp() override {
    AccountWindow::SetUp();
    setUp();
    const auto made = asked<int>([](const SignedIn& by) -> Result<int> {
      const Curriculum curriculum = *loadCurriculum("central_line");
      if (auto published =
              PublishedCurricula(by).publish(curriculum.name, curriculum.version, curriculumText(curriculum));
          !published)
        return tl::unexpected(published.error());
      for (const auto& [cohort, teacher, learner] : {std::tuple{"Mine", "ivy", "tim"}, {"Other", "oz", "una"}}) {
        const auto added = CohortStore(by).add(cohort);
        if (!added) return tl::unexpected(added.error());
        const PeopleStore people(by);
        const auto teaches = people.add({teacher, teacher, "", Role::Instructor}, kFirst, "");
        const auto learns = people.add({learner, learner, "", Role::Trainee}, kFirst, added->id);
        if (!teaches || !learns) return fail("not added");
        if (auto joined = CohortStore(by).join(added->id, teaches->id, true); !joined)
          return tl::unexpected(joined.error());
      }
      return 0;
    });
    ASSERT_TRUE(made) << made.error().message;
  }
  void become(const QString& name) {
    signOut();
    signIn(name, QString::fromLatin1(kFirst));
    QDialog* dialog = dialogWith("passwordNew");
    type(dialog, "passwordOld", QString::fromLatin1(kFirst));
    type(dialog, "passwordNew", "87654321");
    type(dialog, "passwordAgain", "87654321");
    go(dialog);
    ASSERT_TRUE(waitUntil([&] { return !account().mustChangePassword(); }));
  }
  QStringList classesOfCurricula() {
    action("accountLevels").trigger();
    QDialog* dialog = dialogWith("curricula");
    auto* box = dialog->findChild<QComboBox*>("curriculumCohort");
    EXPECT_TRUE(waitUntil([&] { return box->count() > 0; }));
    QStringList names;
    for (int i = 0; i < box->count(); ++i) names << box->itemText(i).section("  (", 0, 0);
    return names;
  }
  QStringList classesOfPeople() {
    action("accountPeople").trigger();
    auto* list = dialogWith("peopleTable")->findChild<QListWidget*>("peopleClasses");
    EXPECT_TRUE(waitUntil([&] { return list->count() > 0; }));
    QStringList names;
    for (int i = 0; i < list->count(); ++i) names << list->item(i)->text();
    return names;
  }

  /// The window of a class list with this one in it, for the class that is shown first.
  QDialog* openList(const QByteArray& text) {
    action("accountPeople").trigger();
    auto* import = dialogWith("peopleTable")->findChild<QPushButton*>("peopleImport");
    EXPECT_TRUE(waitUntil([&] { return import->isEnabled(); }));
    import->click();
    QDialog* dialog = dialogWith("listTable");
    QFile list(home.filePath("list.csv"));
    EXPECT_TRUE(list.open(QFile::WriteOnly) && list.write(text) == text.size());
    list.close();
    qobject_cast<ui::ClassListDialog*>(dialog)->open(list.fileName());
    return dialog;
  }
  static QString displayText(QDialog* dialog) { return dialog->findChild<QLabel*>("listWords")->text(); }

  static constexpr const char* kFirst = "12345678";
};

TEST_F(Roles, AnAdministratorSeesAllClasses) {
  EXPECT_EQ(classesOfCurricula(), (QStringList{"Mine", "Other"}));
  EXPECT_EQ(classesOfPeople().size(), 3) << "everyone, and each class";
  EXPECT_TRUE(action("accountServer").isVisible());
}

TEST_F(Roles, GettingStartedIsThePageOfTheRole) {
  const auto title = [&] {
    window->commands().action("window.help.start")->trigger();
    return window->findChild<QTextBrowser*>()->document()->firstBlock().text();
  };
  EXPECT_EQ(title(), "Your first class") << "an administrator who has just set up a class, even in Train";
  become("ivy");
  EXPECT_EQ(title(), "Your first class");
  become("tim");
  EXPECT_EQ(title(), "Your first central line");
}

TEST_F(Roles, AnInstructorSeesTheOwnClassAndNoOther) {
  become("ivy");
  EXPECT_EQ(classesOfCurricula(), QStringList{"Mine"});
  EXPECT_EQ(classesOfPeople(), QStringList{"Mine"});
  EXPECT_FALSE(action("accountServer").isVisible());
}

TEST_F(Roles, AnInstructorOfAnotherClassDoesNotSeeThisOne) {
  become("oz");
  EXPECT_EQ(classesOfCurricula(), QStringList{"Other"});
  EXPECT_EQ(classesOfPeople(), QStringList{"Other"});
}

TEST_F(Roles, ATraineeHasNoneOfTheseWindows) {
  become("tim");
  for (const char* name : {"accountPeople", "accountLevels", "accountDatabase", "accountServer"})
    EXPECT_FALSE(action(name).isVisible()) << name;
  const auto drafts =
      asked<std::vector<std::string>>([](const SignedIn& by) { return PublishedCurricula(by).drafts(); });
  ASSERT_FALSE(drafts);
  EXPECT_TRUE(QString::fromStdString(drafts.error().message).startsWith("You do not have the permission for this"));
}

TEST_F(Roles, AnInstructorImportsIntoTheOwnClassAndTakesNobodyFromAnother) {
  become("ivy");
  QDialog* dialog = openList("Full name,Username\nNew One,newone\nUna,una\n");
  auto* table = dialog->findChild<QTableWidget*>("listTable");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 2; })) << displayText(dialog).toStdString();
  EXPECT_EQ(row(*table, 0)[4], "+  new");
  EXPECT_TRUE(row(*table, 1)[4].startsWith("▲")) << row(*table, 1)[4].toStdString();
  dialog->findChild<QPushButton*>("listGo")->click();
  ASSERT_TRUE(waitUntil([&] { return dialog->findChild<QPushButton*>("listSave")->isVisible(); }))
      << displayText(dialog).toStdString();
  const auto mine = asked<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); });
  ASSERT_TRUE(mine && mine->size() == 1);
  const auto members =
      asked<std::vector<Member>>([id = mine->front().id](const SignedIn& by) { return CohortStore(by).members(id); });
  EXPECT_EQ(members->size(), 3U) << "ivy, tim and the new one";
}

TEST_F(Roles, WhoDoesNotTeachTheClassAnyMoreIsRefusedInTheOpenWindow) {
  become("ivy");
  QDialog* dialog = openList("Full name,Username\nNew One,newone\n");
  auto* table = dialog->findChild<QTableWidget*>("listTable");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 1; })) << displayText(dialog).toStdString();
  const auto store = CurriculumStore::open(file().toStdString(), {.passwordCost = PasswordCost::Minimum});
  const auto ada = store->signIn("ada", test::kAccountPassword.toStdString());
  ASSERT_TRUE(ada) << ada.error().message;
  const auto cohorts = CohortStore(*ada).cohorts();
  for (const Cohort& one : *cohorts) {
    if (one.name != "Mine") continue;
    ASSERT_TRUE(CohortStore(*ada).leave(one.id, account().person().id));
  }
  dialog->findChild<QPushButton*>("listGo")->click();
  ASSERT_TRUE(waitUntil([&] { return displayText(dialog).contains("You do not have the permission for this"); }))
      << displayText(dialog).toStdString();
  EXPECT_FALSE(dialog->findChild<QPushButton*>("listSave")->isVisible());
  const auto people = PeopleStore(*ada).all();
  for (const Person& one : *people) EXPECT_NE(one.name, "newone");
}

TEST_F(Roles, AGuestHasNoneOfTheseWindows) {
  signOut();
  for (const char* name :
       {"accountPeople", "accountLevels", "accountDatabase", "accountServer", "accountDetails", "accountPassword"})
    EXPECT_FALSE(action(name).isVisible()) << name;
  const auto cohorts = asked<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); });
  ASSERT_FALSE(cohorts);
  EXPECT_TRUE(QString::fromStdString(cohorts.error().message).startsWith("Sign in first")) << cohorts.error().message;
}

TEST_F(Roles, WindowsOfOneCloseForTheNext) {
  action("accountLevels").trigger();
  dialogWith("curricula");
  action("accountPeople").trigger();
  dialogWith("peopleTable");
  signOut();
  EXPECT_TRUE(waitUntil([&] {
    return !window->findChild<QWidget*>("peopleTable") && !window->findChild<QWidget*>("curriculumLevels");
  })) << "nobody reads on in another's window";
}

}  // namespace
