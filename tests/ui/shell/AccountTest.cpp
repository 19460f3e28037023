#include "AccountWindow.h"
#include "support/ReadOnlyFolder.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/ui/SiteExchange.h>
#include <insonate/web/WebServer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QFile>
#include <QFileInfo>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QSysInfo>
#include <QTableWidget>
#include <QTextBlock>
#include <QTextBrowser>
#include <QToolButton>
#include <QtTest/QTest>
#include <filesystem>

namespace {

using namespace insonate;
using test::waitUntil;
using State = ui::Account::State;

const QString kPassword = test::kAccountPassword;
using AccountWindow = test::AccountWindow;

TEST_F(AccountWindow, NothingIsWrittenBeforeSomebodySetsUp) {
  EXPECT_EQ(account().state(), State::NoUsers);
  EXPECT_EQ(header(), "Guest");
  EXPECT_TRUE(action("accountSetUp").isVisible());
  EXPECT_FALSE(action("accountSignIn").isVisible());
  EXPECT_FALSE(QFile::exists(file()));
  EXPECT_FALSE(asked<Person>([](const SignedIn& by) { return PeopleStore(by).person("x"); }));
  EXPECT_FALSE(QFile::exists(file()));
}

TEST_F(AccountWindow, TheFirstOneIsTheAdministratorAndStaysSo) {
  action("accountSetUp").trigger();
  QDialog* dialog = dialogWith("setUpName");
  type(dialog, "setUpName", "ada");
  type(dialog, "setUpFullName", "Ada L. & Co");
  type(dialog, "setUpPassword", kPassword);
  type(dialog, "setUpAgain", "another sentence");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return error(dialog).contains("differ"); }));
  EXPECT_FALSE(QFile::exists(file()));
  type(dialog, "setUpAgain", kPassword);
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  EXPECT_EQ(account().person().role, Role::Administrator);
  EXPECT_EQ(header(), "Ada L. && Co") << "an ampersand is no key";
  EXPECT_FALSE(action("accountSetUp").isVisible());

  window.reset();
  open();
  EXPECT_EQ(account().state(), State::Guest) << "somebody else may sit there now";
  signIn("ada", kPassword);
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
}

TEST_F(AccountWindow, OnePersonAloneStaysSignedInAndHasLevels) {
  window->askAtFirstStart();
  QDialog* dialog = dialogWith("aloneName");
  ASSERT_TRUE(dialog);
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return !error(dialog).isEmpty(); })) << "a name is needed";
  EXPECT_EQ(dialog->focusWidget()->objectName(), "aloneName") << "not the password, which hides what is typed";
  type(dialog, "aloneName", "Ada Lovelace");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  EXPECT_EQ(header(), "Ada Lovelace");
  const auto cohorts = asked<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); });
  ASSERT_TRUE(cohorts);
  ASSERT_EQ(cohorts->size(), 1U);
  EXPECT_FALSE(cohorts->front().curriculum.empty());
  EXPECT_FALSE(action("accountSignOut").isEnabled()) << "nobody knows the generated password";

  window.reset();
  const auto kept = QFile::permissions(file() + ".signed-in");
  EXPECT_EQ(kept & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteOther), QFile::Permissions());
  open();
  EXPECT_TRUE(account().isSignedIn());
  window->askAtFirstStart();
  EXPECT_FALSE(QApplication::activeModalWidget()) << "asked once";
}

TEST_F(AccountWindow, OneWhoChoosesAPasswordCanSignOutAndIn) {
  window->askAtFirstStart();
  QDialog* dialog = dialogWith("aloneName");
  type(dialog, "aloneName", "Ada");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  action("accountPassword").trigger();
  dialog = dialogWith("passwordNew");
  EXPECT_FALSE(dialog->findChild<QLineEdit*>("passwordOld")) << "nobody knows the generated one";
  type(dialog, "passwordNew", kPassword);
  type(dialog, "passwordAgain", kPassword);
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return !account().hasGeneratedPassword(); }));

  window.reset();
  open();
  EXPECT_TRUE(account().isSignedIn()) << "the new password keeps it so";
  signOut();
  ASSERT_TRUE(waitUntil([&] { return account().state() == State::Guest; }));
  window.reset();
  open();
  EXPECT_EQ(account().state(), State::Guest);
  signIn("ada", kPassword);
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
}

TEST_F(AccountWindow, AGeneratedPasswordIsKeptThoughItIsRefusedNow) {
  setUpAlone("Ada", {});
  ASSERT_TRUE(account().hasGeneratedPassword());
  window.reset();
  QFile kept(file() + ".signed-in");
  ASSERT_TRUE(kept.open(QFile::ReadOnly));
  const QByteArray before = kept.readAll();
  kept.close();
  ASSERT_TRUE(QFile::rename(file(), file() + ".away"));
  ASSERT_TRUE(CurriculumStore::open(file().toStdString(), {.passwordCost = PasswordCost::Minimum})
                  .value()
                  .createFirstAdministrator({.name = "cleo", .fullName = "Cleo"}, kPassword.toStdString()));
  open();
  EXPECT_EQ(account().state(), State::Guest) << "this store knows no Ada";
  signIn("cleo", kPassword);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  EXPECT_FALSE(account().hasGeneratedPassword()) << "the kept password is another person's";
  signOut();
  window.reset();
  ASSERT_TRUE(kept.open(QFile::ReadOnly)) << "signing out ends the own sign-in only";
  EXPECT_EQ(kept.readAll(), before);
  ASSERT_TRUE(QFile::remove(file()) && QFile::rename(file() + ".away", file()));
  open();
  EXPECT_TRUE(account().isSignedIn());
  EXPECT_TRUE(account().hasGeneratedPassword());
}

TEST_F(AccountWindow, NobodyIsSetUpWhoseGeneratedPasswordCannotBeKept) {
  QDir(home.path()).mkpath("people/curriculum.sqlite.signed-in/in the way");
  const Result<void> refused = setUpAlone("Ada", {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(account().state(), State::NoUsers);
  EXPECT_TRUE(setUpAlone("Ada", kPassword)) << "who knows the password can sign in again";
  EXPECT_TRUE(account().isSignedIn());
  EXPECT_FALSE(account().hasGeneratedPassword());
  signOut();
  signIn("ada", kPassword);
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
}

TEST_F(AccountWindow, AChosenPasswordKeepsOneSignedInToo) {
  ASSERT_TRUE(setUpAlone("Ada", kPassword));
  EXPECT_FALSE(account().hasGeneratedPassword());
  window.reset();
  open();
  EXPECT_TRUE(account().isSignedIn());
  signOut();
  EXPECT_FALSE(QFile::exists(file() + ".signed-in"));
}

TEST_F(AccountWindow, AFileThatCanOnlyBeReadIsReadAndSaidToBeSo) {
  ASSERT_TRUE(setUpAlone("Ada", kPassword));
  signOut();
  window.reset();
  std::filesystem::permissions(home.path().toStdString(), std::filesystem::perms(0755));
  const test::ReadOnlyFolder people(QFileInfo(file()).absolutePath().toStdString());
  open();
  EXPECT_FALSE(account().isSignedIn());
  signIn("ada", kPassword);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  EXPECT_TRUE(account().isReadOnly());
  EXPECT_EQ(header(), "Ada (read-only)");
  EXPECT_TRUE(window->statusText().contains("can only be read")) << window->statusText().toStdString();
  window.reset();
}

TEST_F(AccountWindow, AtTheFirstStartAClassIsOfferedToo) {
  window->askAtFirstStart();
  QDialog* dialog = dialogWith("aloneName");
  dialog->findChild<QPushButton*>("entryOther")->click();
  EXPECT_TRUE(dialogWith("setUpName"));
  EXPECT_FALSE(QFile::exists(file()));
}

TEST_F(AccountWindow, TheFirstStartLeadsAnAuthorToPrepare) {
  window->addWorkspace("prepare", "Prepare", "prepare",
                       new ui::EmptyWorkspace({"prepare", "Prepare", {}, {}, "prepare"}));
  window->askAtFirstStart();
  dialogWith("aloneName")->findChild<QPushButton*>("entryAuthor")->click();
  EXPECT_EQ(window->currentWorkspace()->helpPage(), "prepare");
  auto* help = window->findChild<QTextBrowser*>();
  ASSERT_TRUE(help && help->isVisible());
  EXPECT_EQ(help->document()->firstBlock().text(), "Your first case");
  QTest::qWait(100);
  EXPECT_FALSE(QApplication::activeModalWidget()) << "an author is not asked for hands";
  EXPECT_FALSE(QFile::exists(file())) << "and needs no account";
}

TEST_F(AccountWindow, TheFirstStartAsksForTheHandsAfterThePerson) {
  std::optional<ui::HandsChoice> chosen;
  QObject::connect(window.get(), &ui::MainWindow::handsChosen, window.get(),
                   [&](ui::HandsChoice choice) { chosen = choice; });
  window->askAtFirstStart();
  QDialog* person = dialogWith("aloneName");
  EXPECT_FALSE(window->findChild<QDialog*>("handsDialog")) << "one question at a time";
  person->reject();
  ASSERT_TRUE(waitUntil([&] { return window->findChild<QDialog*>("handsDialog") != nullptr; }));
  auto* hands = window->findChild<QDialog*>("handsDialog");
  for (const char* answer : {"handsMouse", "handsCamera", "handsController", "handsHaptic"})
    EXPECT_FALSE(hands->findChild<QToolButton*>(answer)->icon().isNull()) << answer;
  hands->findChild<QToolButton*>("handsCamera")->click();
  EXPECT_EQ(chosen, ui::HandsChoice::Camera);
  EXPECT_TRUE(waitUntil([&] { return !window->findChild<QDialog*>("handsDialog"); }));
  window->askAtFirstStart();
  EXPECT_FALSE(QApplication::activeModalWidget()) << "asked once";
}

TEST_F(AccountWindow, AWrongPasswordIsSaidInTheDialogWhichStays) {
  setUp();
  signOut();
  signIn("ada", "not the password");
  QDialog* dialog = dialogWith("signInName");
  ASSERT_TRUE(waitUntil([&] { return !error(dialog).isEmpty(); }));
  EXPECT_EQ(account().state(), State::Guest);
  const QString said = error(dialog);
  EXPECT_EQ(dialog->findChild<QLineEdit*>("signInName")->text(), "ada");
  for (const auto* line : dialog->findChildren<QLineEdit*>())
    EXPECT_GE(line->height(), line->sizeHint().height()) << "the sentence takes no room from what is filled in";
  type(dialog, "signInName", "nobody");
  type(dialog, "signInPassword", "not the password");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return dialog->findChild<QPushButton*>("entryGo")->isEnabled(); }));
  EXPECT_EQ(error(dialog), said) << "who guesses names learns nothing";
  type(dialog, "signInName", "ada");
  type(dialog, "signInPassword", kPassword);
  go(dialog);
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
}

TEST_F(AccountWindow, AnswersReachNobodyElse) {
  setUp();
  Result<Person> told = fail("");
  bool there = false;
  account().query<Person>(
      window.get(), [](const SignedIn& by) { return PeopleStore(by).person(by.person().id); },
      [&](const Result<Person>& person) { told = person, there = true; });
  account().signOut();
  ASSERT_TRUE(waitUntil([&] { return there && account().state() == State::Guest; }));
  ASSERT_FALSE(told) << "a guest saw " << told->fullName;
  EXPECT_THAT(told.error().message, testing::HasSubstr("signed in meanwhile"));
}

TEST_F(AccountWindow, WhatWasAskedIsDoneBeforeTheWindowGoes) {
  setUp();
  account().query<Cohort>(window.get(), [](const SignedIn& by) { return CohortStore(by).add("Autumn"); }, {});
  window.reset();
  open();
  signIn("ada", kPassword);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  const auto cohorts = asked<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); });
  ASSERT_TRUE(cohorts && cohorts->size() == 1);
  EXPECT_EQ(cohorts->front().name, "Autumn");
}

TEST_F(AccountWindow, AStoreThatCannotBeReadIsSaidAndTriedAgain) {
  window.reset();
  QDir(home.path()).mkdir("people");
  QFile broken(file());
  ASSERT_TRUE(broken.open(QFile::WriteOnly));
  broken.write(QByteArray(5000, 'x'));
  broken.close();
  open();
  EXPECT_EQ(account().state(), State::Unreachable);
  EXPECT_TRUE(account().error().contains("curriculum.sqlite")) << account().error().toStdString();
  EXPECT_EQ(window->statusText(), account().error());
  EXPECT_TRUE(action("accountAgain").isVisible());
  ASSERT_TRUE(QFile::remove(file()));
  action("accountAgain").trigger();
  EXPECT_TRUE(waitUntil([&] { return account().state() == State::NoUsers; }));
}

TEST_F(AccountWindow, AnAdministratorMakesAClassAndATraineeWhoChoosesAPassword) {
  setUp();
  const QSignalSpy told(&account(), &ui::Account::peopleChanged);
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  people->findChild<QPushButton*>("peopleAddClass")->click();
  QDialog* dialog = dialogWith("className");
  const QString hostile = "<b>Autumn</b> & '; DROP TABLE person;--";
  type(dialog, "className", hostile);
  go(dialog);
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  ASSERT_TRUE(waitUntil([&] { return classes->count() == 2; }));
  EXPECT_EQ(classes->item(1)->text(), hostile);
  EXPECT_EQ(classes->currentRow(), 1) << "the new one is what one goes on with";

  auto* curriculum = people->findChild<QComboBox*>("peopleCurriculum");
  ASSERT_TRUE(waitUntil([&] { return curriculum->count() == 2; }));
  EXPECT_TRUE(curriculum->itemText(1).contains("comes with Insonate"));
  curriculum->setFocus();
  QTest::keyClick(curriculum, Qt::Key_Down);
  const QString built = QStringLiteral("central_line, version %1").arg(loadCurriculum("central_line")->version);
  ASSERT_TRUE(waitUntil([&] { return curriculum->currentText() == built; }))
      << "published and set: " << curriculum->currentText().toStdString();

  people->findChild<QPushButton*>("peopleAdd")->click();
  dialog = dialogWith("personName");
  type(dialog, "personName", "tim");
  type(dialog, "personFullName", "Tim T.");
  const QString handed = dialog->findChild<QLineEdit*>("personPassword")->text();
  EXPECT_GE(handed.size(), 12);
  go(dialog);
  dialog = dialogWith("firstPassword");
  EXPECT_EQ(dialog->findChild<QLineEdit*>("firstPassword")->text(), handed) << "also after the person was added";
  go(dialog);
  EXPECT_EQ(QGuiApplication::clipboard()->text(), handed);
  auto* table = people->findChild<QTableWidget*>("peopleTable");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 1 && table->item(0, 1)->text() == "tim"; }));
  EXPECT_EQ(row(*table, 0), (QStringList{"Tim T.", "tim", "", "trainee", ""}));
  EXPECT_EQ(told.count(), 3) << "class, curriculum and person: the other windows read again";

  signOut();
  EXPECT_TRUE(waitUntil([&] { return window->findChild<QTableWidget*>("peopleTable") == nullptr; }))
      << "nobody sees what was read for the one before";
  signIn("tim", handed);
  dialog = dialogWith("passwordNew");
  EXPECT_FALSE(action("accountPeople").isVisible());
  type(dialog, "passwordOld", handed);
  type(dialog, "passwordNew", "my own sentence");
  type(dialog, "passwordAgain", "my own sentence");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return !account().mustChangePassword(); }));
  EXPECT_TRUE(
      asked<std::vector<StoredAttempt>>([](const SignedIn& by) { return AttemptStore(by).page(by.person().id, 10); }));
}

TEST_F(AccountWindow, AnAdministratorArchivesRestoresAndDeletesAClass) {
  setUp();
  ASSERT_TRUE(asked<Cohort>([](const SignedIn& by) { return CohortStore(by).add("Autumn"); }));
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  const auto press = [&](const char* name) {
    auto* button = people->findChild<QPushButton*>(name);
    EXPECT_TRUE(waitUntil([&] { return button->isEnabled(); })) << name;
    button->click();
  };
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  ASSERT_TRUE(waitUntil([&] { return classes->count() == 2; }));
  classes->setCurrentRow(1);
  press("peopleArchive");
  go(dialogWith("entryGo"));
  ASSERT_TRUE(waitUntil([&] { return classes->item(1)->text() == "Autumn (archived)"; }));
  for (const char* name : {"peopleCurriculum", "peopleImport", "peopleAdd"})
    EXPECT_FALSE(people->findChild<QWidget*>(name)->isEnabled()) << name;
  EXPECT_EQ(people->findChild<QPushButton*>("peopleArchive")->text(), "Restore");
  press("peopleArchive");
  ASSERT_TRUE(waitUntil([&] { return classes->item(1)->text() == "Autumn"; }));
  EXPECT_TRUE(people->findChild<QWidget*>("peopleImport")->isEnabled());
  press("peopleDelete");
  QDialog* question = dialogWith("className");
  type(question, "className", "Spring");
  go(question);
  ASSERT_TRUE(waitUntil([&] { return error(question).contains("is not the name"); })) << error(question).toStdString();
  type(question, "className", "Autumn");
  go(question);
  EXPECT_TRUE(waitUntil([&] { return classes->count() == 1; }));
}

TEST_F(AccountWindow, AnotherCurriculumIsAskedAboutSinceProgressChanges) {
  setUp();
  const auto made = asked<Cohort>([](const SignedIn& by) -> Result<Cohort> {
    Curriculum curriculum = *loadCurriculum("central_line");
    const PublishedCurricula curricula(by);
    for (const int version : {100, 101}) {
      curriculum.version = version;
      if (auto done = curricula.publish(curriculum.name, version, curriculumText(curriculum)); !done)
        return tl::unexpected(done.error());
    }
    auto cohort = CohortStore(by).add("Autumn");
    if (auto set = CohortStore(by).setCurriculum(cohort->id, curriculum.name, 100); !set)
      return tl::unexpected(set.error());
    return cohort;
  });
  ASSERT_TRUE(made) << made.error().message;
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  auto* curriculum = people->findChild<QComboBox*>("peopleCurriculum");
  ASSERT_TRUE(waitUntil([&] { return classes->count() == 2; }));
  classes->setCurrentRow(1);
  const auto choose = [&] {
    curriculum->setCurrentText("central_line, version 101");
    Q_EMIT curriculum->activated(curriculum->currentIndex());
    return dialogWith("entryGo");
  };
  const auto version = [&] {
    return asked<std::vector<Cohort>>([](const SignedIn& by) { return CohortStore(by).cohorts(); })
        ->front()
        .curriculumVersion;
  };
  choose()->reject();
  EXPECT_EQ(curriculum->currentText(), "central_line, version 100");
  EXPECT_EQ(version(), 100);
  go(choose());
  EXPECT_TRUE(waitUntil([&] { return version() == 101; }));
}

TEST_F(AccountWindow, PeopleAreSortedByTheLanguageAndByTheHeader) {
  setUp();
  const auto made = asked<int>([](const SignedIn& by) -> Result<int> {
    for (const auto& [name, full] : {std::pair{"c1", "Zoë"}, {"b1", "Änne"}, {"d1", "Ömer"}})
      if (auto added = PeopleStore(by).add({name, full, "", Role::Trainee}, "12345678", ""); !added)
        return tl::unexpected(added.error());
    return 0;
  });
  ASSERT_TRUE(made) << made.error().message;
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  auto* table = people->findChild<QTableWidget*>("peopleTable");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 4; }));
  const auto column = [&](int at) {
    QStringList texts;
    for (int row = 0; row < table->rowCount(); ++row) texts << table->item(row, at)->text();
    return texts;
  };
  EXPECT_EQ(column(0), (QStringList{"Ada L.", "Änne", "Ömer", "Zoë"})) << column(0).join(", ").toStdString();
  table->horizontalHeader()->setSortIndicator(1, Qt::DescendingOrder);
  EXPECT_EQ(column(1), (QStringList{"d1", "c1", "b1", "ada"})) << column(1).join(", ").toStdString();
}

TEST_F(AccountWindow, KeysOfHelpAndSigningInSayWhatTheyDo) {
  setUp();
  QApplication::setActiveWindow(window.get());
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return window->statusText().contains("Ada L. is signed in. Sign out first"); }))
      << window->statusText().toStdString();
  const auto helpText = [&] {
    const auto* page = window->findChild<QTextBrowser*>();
    return page ? page->toPlainText() : QString();
  };
  QTest::keyClick(window.get(), Qt::Key_F1, Qt::ShiftModifier);
  EXPECT_TRUE(waitUntil([&] { return helpText().startsWith("Your first class"); }))
      << helpText().left(80).toStdString();
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  QApplication::setActiveWindow(people);
  QTest::keyClick(people, Qt::Key_F1);
  EXPECT_TRUE(waitUntil([&] { return helpText().startsWith("People and classes"); }))
      << helpText().left(80).toStdString();
}

TEST_F(AccountWindow, AnInstructorSeesTheOwnClassOnly) {
  setUp();
  const auto made = asked<int>([](const SignedIn& by) -> Result<int> {
    const PeopleStore people(by);
    const CohortStore cohorts(by);
    const auto mine = cohorts.add("Mine"), other = cohorts.add("Other");
    const auto ivy = people.add({"ivy", "Ivy I.", "", Role::Instructor}, "12345678", "");
    if (!mine || !other || !ivy) return fail("not added");
    if (!people.add({"tim", "Tim T.", "", Role::Trainee}, "12345678", mine->id)) return fail("not added");
    if (!people.add({"una", "Una U.", "", Role::Trainee}, "12345678", other->id)) return fail("not added");
    return cohorts.join(mine->id, ivy->id, true).map([] { return 0; });
  });
  ASSERT_TRUE(made) << made.error().message;
  signOut();
  signIn("ivy", "12345678");
  QDialog* dialog = dialogWith("passwordNew");
  type(dialog, "passwordOld", "12345678");
  type(dialog, "passwordNew", "87654321");
  type(dialog, "passwordAgain", "87654321");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return !account().mustChangePassword(); }));
  action("accountPeople").trigger();
  QDialog* people = dialogWith("peopleTable");
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  auto* table = people->findChild<QTableWidget*>("peopleTable");
  ASSERT_TRUE(waitUntil([&] { return classes->count() == 1 && table->rowCount() == 2; }));
  EXPECT_EQ(classes->item(0)->text(), "Mine");
  EXPECT_EQ(row(*table, 0)[3], "instructor, teacher");
  EXPECT_FALSE(people->findChild<QPushButton*>("peopleAddClass")->isVisible());
  EXPECT_FALSE(people->findChild<QPushButton*>("peopleDisable")->isVisible());
}

TEST_F(AccountWindow, WhatIsDoneHereReachesTheServerAndItsPeopleComeHere) {
  const std::string server = home.filePath("server.sqlite").toStdString();
  {
    const auto store = CurriculumStore::open(server, {.workstation = "server", .passwordCost = PasswordCost::Minimum});
    ASSERT_TRUE(store);
    const auto root = store->createFirstAdministrator({"root", "Root R.", "", Role::Administrator}, "12345678");
    ASSERT_TRUE(root && CohortStore(*root).add("Everywhere"));
  }
  setUp();
  action("accountServer").trigger();
  QDialog* dialog = dialogWith("serverAddress");
  auto* site = window->findChild<ui::SiteExchange*>();
  for (const char* address : {"postgresql://me@there/db", "postgres://me:secret@there/db"}) {
    type(dialog, "serverAddress", address);
    go(dialog);
    ASSERT_TRUE(waitUntil([&] { return error(dialog).contains("https://"); })) << error(dialog).toStdString();
    EXPECT_EQ(site->server(), "") << "nothing is stored";
  }
  type(dialog, "serverAddress", "https://me:secret@there");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return error(dialog).contains("Remove the password"); })) << error(dialog).toStdString();
  type(dialog, "serverAddress", QString::fromStdString(server));
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return !site->outcome().isEmpty(); }));
  EXPECT_TRUE(site->outcome().startsWith("Sent to the server:")) << site->outcome().toStdString();
  EXPECT_EQ(window->statusText(), site->outcome());
  signOut();
  signIn("root", "12345678");
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); })) << "people come from the server";

  ASSERT_TRUE(site->setServer(home.filePath("nowhere/server.sqlite")));
  EXPECT_TRUE(waitUntil([&] { return site->outcome().contains("The exchange with the server failed"); }))
      << site->outcome().toStdString();
}

/// A database with a trainee, served at a port of this computer.
struct ServedSite {
  explicit ServedSite(const std::string& file) {
    auto store = CurriculumStore::open(file, {.workstation = "server", .passwordCost = PasswordCost::Minimum});
    if (!store) throw std::runtime_error(store.error().message);
    const auto root = store->createFirstAdministrator({"root", "Root R.", "", Role::Administrator}, kPassword);
    if (!root) throw std::runtime_error(root.error().message);
    if (!PeopleStore(*root).add({"anna", "Anna A.", "", Role::Trainee}, kFirst)) throw std::runtime_error("no anna");
    token = Workstations(*root).add(QSysInfo::machineHostName().toStdString()).value_or("");
    auto started = web::WebServer::start(*store, {.port = 0});
    if (!started) throw std::runtime_error(started.error().message);
    server.emplace(std::move(*started));
  }
  QString url() const { return QString::fromStdString(server->url()); }

  static constexpr const char *kPassword = "12345678", *kFirst = "set by root";
  std::string token;
  std::optional<web::WebServer> server;
};

TEST_F(AccountWindow, AnEmptyWorkstationJoinsASiteAndPeopleSignInWithTheirPasswordsThere) {
  ServedSite served(home.filePath("served.sqlite").toStdString());
  action("accountServer").trigger();
  QDialog* dialog = dialogWith("serverAddress");
  type(dialog, "serverAddress", served.url());
  type(dialog, "serverToken", "no token");
  go(dialog);
  ASSERT_TRUE(waitUntil([&] { return error(dialog).contains("token"); })) << error(dialog).toStdString();
  type(dialog, "serverToken", QString::fromStdString(served.token));
  go(dialog);
  QDialog* signingIn = dialogWith("signInName");
  ASSERT_TRUE(signingIn) << error(dialog).toStdString();
  type(signingIn, "signInName", "anna");
  type(signingIn, "signInPassword", "a wrong one");
  go(signingIn);
  ASSERT_TRUE(waitUntil([&] { return error(signingIn).contains("password"); })) << error(signingIn).toStdString();
  type(signingIn, "signInPassword", ServedSite::kFirst);
  go(signingIn);
  QDialog* choosing = dialogWith("passwordNew");
  ASSERT_TRUE(choosing) << "another user has set the first password";
  type(choosing, "passwordOld", ServedSite::kFirst);
  type(choosing, "passwordNew", "of my own choice");
  type(choosing, "passwordAgain", "of my own choice");
  go(choosing);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn() && !account().mustChangePassword(); }))
      << error(choosing).toStdString();
  served.server.reset();
  signOut();
  signIn("anna", "of my own choice");
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); })) << "without the server, too";
  signOut();
  signIn("root", ServedSite::kPassword);
  EXPECT_TRUE(waitUntil([&] { return error(dialogWith("signInName")).contains("signed in on this computer"); }));
}

TEST_F(AccountWindow, NoKeyMeansTwoThings) {
  setUp();
  const auto expectOne = [&] {
    QStringList keys;
    for (const QAction* one : window->actions())
      if (one->isVisible() && one->isEnabled())
        for (const QKeySequence& key : one->shortcuts()) keys << key.toString();
    EXPECT_GT(keys.size(), 8);
    EXPECT_EQ(keys.removeDuplicates(), 0) << keys.join(' ').toStdString();
  };
  expectOne();
  signOut();
  expectOne();
  QApplication::setActiveWindow(window.get());
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_TRUE(dialogWith("signInName"));
}

}  // namespace
