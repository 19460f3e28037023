#include "AccountWindow.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <ui/support/Beat.h>
#include <unit/curriculum/PostgresServer.h>

#include <QDropEvent>
#include <QFile>
#include <QListWidget>
#include <QMimeData>
#include <QUrl>

namespace {

using namespace insonate;
using test::waitUntil;

/// People are kept on a server, which goes between two clicks and comes back, without anybody asking for it.
class ServerAwayWindows : public test::AccountWindow {
 protected:
  void SetUp() override {
    server_ = test::PostgresServer::shared();
    if (!server_) GTEST_SKIP() << "PostgreSQL 15 is not installed";
    address_ = QString::fromStdString(server_->freshDatabase());
    AccountWindow::SetUp();
    setUp();
    ASSERT_TRUE(asked<Cohort>([](const SignedIn& by) { return CohortStore(by).add("Autumn"); }));
    beat_.start();
  }
  void TearDown() override {
    if (server_) server_->start();
  }
  QString file() const override { return address_; }

  static bool isServerUnreachable(const QString& sentence) {
    return sentence.contains("cannot be reached") && sentence.contains("try again") && !sentence.contains("a b/c@d");
  }
  QDialog* openPeople() {
    action("accountPeople").trigger();
    QDialog* people = dialogWith("peopleTable");
    EXPECT_TRUE(waitUntil([&] { return people->findChild<QListWidget*>("peopleClasses")->count() == 2; }));
    return people;
  }
  /// A silent server is waited for 10 s; a busy machine pauses a window for one.
  void expectNoPause() { EXPECT_LT(beat_.longest_ms(), 3000) << "the window's thread waits for no server"; }

  test::PostgresServer* server_ = nullptr;
  QString address_;
  test::Beat beat_;
};

TEST_F(ServerAwayWindows, PeopleAreShownAgainAndWhatWasTypedIsAdded) {
  QDialog* people = openPeople();
  auto* classes = people->findChild<QListWidget*>("peopleClasses");
  auto* table = people->findChild<QTableWidget*>("peopleTable");
  auto* error = people->findChild<QLabel*>("peopleTrouble");
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 1; }));
  server_->fallSilent();
  classes->setCurrentRow(1);
  ASSERT_TRUE(waitUntil([&] { return error->isVisible(); }));
  EXPECT_TRUE(isServerUnreachable(error->text())) << error->text().toStdString();
  people->findChild<QPushButton*>("peopleAddClass")->click();
  QDialog* entry = dialogWith("className");
  type(entry, "className", "Winter");
  go(entry);
  ASSERT_TRUE(waitUntil([&] { return isServerUnreachable(AccountWindow::error(entry)); }))
      << AccountWindow::error(entry).toStdString();
  EXPECT_EQ(entry->findChild<QLineEdit*>("className")->text(), "Winter");
  expectNoPause();

  server_->start();
  ASSERT_TRUE(waitUntil([&] { return !error->isVisible() && table->rowCount() == 0; })) << "of Autumn is nobody";
  EXPECT_EQ(classes->currentRow(), 1);
  go(entry);
  EXPECT_TRUE(waitUntil([&] { return classes->count() == 3; })) << error->text().toStdString();
  EXPECT_TRUE(account().isSignedIn()) << "nobody has to sign in again";
}

TEST_F(ServerAwayWindows, ADraftThatIsWrittenIsSavedOnceItIsBack) {
  action("accountLevels").trigger();
  QDialog* dialog = dialogWith("curricula");
  const auto state = [&] { return dialog->findChild<QLabel*>("curriculumState")->text(); };
  auto* words = dialog->findChild<QLabel*>("curriculumWords");
  auto* shelf = dialog->findChild<QListWidget*>("curricula");
  ASSERT_TRUE(waitUntil([&] { return shelf->count() == 1 && !state().startsWith("Choose"); }));
  dialog->findChild<QPushButton*>("curriculumVersion")->click();
  ASSERT_TRUE(waitUntil([&] { return state().endsWith(", saved") && shelf->count() == 2; }));
  server_->crash();
  auto* title = dialog->findChild<QLineEdit*>("curriculumTitle");
  title->setFocus();
  title->selectAll();
  QTest::keyClicks(title, "Written meanwhile");
  ASSERT_TRUE(waitUntil([&] { return isServerUnreachable(words->text()); })) << words->text().toStdString();
  EXPECT_TRUE(state().endsWith("not saved yet")) << state().toStdString();
  shelf->setCurrentRow(1);
  ASSERT_TRUE(waitUntil([&] { return shelf->currentRow() == 0; })) << "the one that is shown stays chosen";
  EXPECT_EQ(title->text(), "Written meanwhile");
  dialog->close();
  QDialog* question = dialogWith("entryGo");
  EXPECT_TRUE(question->windowTitle().startsWith("Close without")) << question->windowTitle().toStdString();
  question->reject();
  EXPECT_TRUE(dialog->isVisible());
  expectNoPause();

  server_->start();
  ASSERT_TRUE(waitUntil([&] { return state().endsWith(", saved"); })) << words->text().toStdString();
  EXPECT_FALSE(words->isVisible()) << words->text().toStdString();
  const auto draft =
      asked<std::string>([](const SignedIn& by) { return PublishedCurricula(by).draft("central_line"); });
  ASSERT_TRUE(draft) << draft.error().message;
  EXPECT_EQ(parseDraft(*draft)->title, "Written meanwhile");
}

TEST_F(ServerAwayWindows, AClassListIsReadAndAddedOnceItIsBack) {
  QDialog* people = openPeople();
  people->findChild<QListWidget*>("peopleClasses")->setCurrentRow(1);
  auto* import = people->findChild<QPushButton*>("peopleImport");
  ASSERT_TRUE(waitUntil([&] { return import->isEnabled(); }));
  import->click();
  QDialog* dialog = dialogWith("listTable");
  auto* table = dialog->findChild<QTableWidget*>("listTable");
  auto* words = dialog->findChild<QLabel*>("listWords");
  auto* add = dialog->findChild<QPushButton*>("listGo");
  server_->fallSilent();
  drop(dialog, "Full name,Username\nZoe,zoe\n");
  ASSERT_TRUE(waitUntil([&] { return isServerUnreachable(words->text()); })) << words->text().toStdString();
  EXPECT_FALSE(add->isEnabled());
  server_->start();
  ASSERT_TRUE(waitUntil([&] { return table->rowCount() == 1 && add->isEnabled(); })) << words->text().toStdString();

  server_->crash();
  add->click();
  ASSERT_TRUE(waitUntil([&] { return isServerUnreachable(words->text()); })) << words->text().toStdString();
  EXPECT_EQ(table->rowCount(), 1) << "what was read stays";
  expectNoPause();
  server_->start();
  ASSERT_TRUE(waitUntil([&] { return words->text().startsWith("1 new"); })) << words->text().toStdString();
  add->click();
  EXPECT_TRUE(waitUntil([&] { return dialog->findChild<QPushButton*>("listSave")->isVisible(); }))
      << words->text().toStdString();
}

TEST_F(ServerAwayWindows, WhoSignsInWaitsForItAndTypesNothingAgain) {
  signOut();
  server_->fallSilent();
  signIn("ada", test::kAccountPassword);
  QDialog* dialog = dialogWith("signInName");
  ASSERT_TRUE(waitUntil([&] { return isServerUnreachable(AccountWindow::error(dialog)); }))
      << AccountWindow::error(dialog).toStdString();
  EXPECT_EQ(header(), "Guest, no database");
  server_->start();
  ASSERT_TRUE(waitUntil([&] { return header() == "Guest"; })) << "nobody has to ask for it";
  EXPECT_EQ(dialog->findChild<QLineEdit*>("signInName")->text(), "ada");
  go(dialog);
  EXPECT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  expectNoPause();
}

}  // namespace
