#include "AccountWindow.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <QComboBox>
#include <QListWidget>

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

  static constexpr const char* kFirst = "12345678";
};

TEST_F(Roles, AnAdministratorSeesAllClasses) {
  EXPECT_EQ(classesOfCurricula(), (QStringList{"Mine", "Other"}));
  EXPECT_EQ(classesOfPeople().size(), 3) << "everyone, and each class";
  EXPECT_TRUE(action("accountServer").isVisible());
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
  for (const char* name : {"accountPeople", "accountLevels", "accountServer"})
    EXPECT_FALSE(action(name).isVisible()) << name;
  const auto drafts =
      asked<std::vector<std::string>>([](const SignedIn& by) { return PublishedCurricula(by).drafts(); });
  ASSERT_FALSE(drafts);
  EXPECT_TRUE(QString::fromStdString(drafts.error().message).startsWith("You may not do this"));
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
