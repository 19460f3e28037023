#include "AccountWindow.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>

#include <gmock/gmock.h>
#include <ui/support/AccessibleNames.h>

#include <QDropEvent>
#include <QFile>
#include <QListWidget>
#include <QMimeData>
#include <QPointer>
#include <QUrl>

namespace {

using namespace insonate;
using test::waitUntil;

/// An administrator looks at the class "Autumn", and has a list.
class ClassListWindow : public test::AccountWindow {
 protected:
  void SetUp() override {
    AccountWindow::SetUp();
    setUp();
    ASSERT_TRUE(asked<Cohort>([](const SignedIn& by) { return CohortStore(by).add("Autumn"); }));
    action("accountPeople").trigger();
    people_ = dialogWith("peopleTable");
    auto* classes = people_->findChild<QListWidget*>("peopleClasses");
    ASSERT_TRUE(waitUntil([&] { return classes->count() == 2; }));
    classes->setCurrentRow(1);
    auto* import = people_->findChild<QPushButton*>("peopleImport");
    ASSERT_TRUE(waitUntil([&] { return import->isEnabled(); }));
    import->click();
    dialog_ = dialogWith("listTable");
  }

  void drop(const QByteArray& list) {
    AccountWindow::drop(dialog_, list);
    ASSERT_TRUE(waitUntil([&] { return !words().startsWith("Reading"); }));
  }
  QString words() { return dialog_->findChild<QLabel*>("listWords")->text(); }
  QTableWidget& table() { return *dialog_->findChild<QTableWidget*>("listTable"); }
  QPushButton& button(const char* name) { return *dialog_->findChild<QPushButton*>(name); }

  QDialog *people_ = nullptr, *dialog_ = nullptr;
};

TEST_F(ClassListWindow, ShowsWhatBecomesOfEachLineThenDoesItAndHandsPasswordsOut) {
  EXPECT_FALSE(button("listGo").isEnabled());
  const QString hostile = "<b>Zo\u00eb</b> & 'DROP %1 \u0645\u0631";
  drop(
      "\xEF\xBB\xBF"
      "Full name;Username;E-mail\r\n" +
      hostile.toUtf8() + ";zoe;zoe@example.org\r\nNobody;;\r\nAda;ada;\r\nX;x;no mail\r\nZoe;ZOE;\r\n");
  ASSERT_EQ(table().rowCount(), 5);
  EXPECT_EQ(row(table(), 0), (QStringList{"2", hostile, "zoe", "zoe@example.org", "+  new"}));
  EXPECT_THAT(row(table(), 1)[4].toStdString(), testing::StartsWith("▲  There is neither"));
  EXPECT_EQ(row(table(), 2)[4], "+  has an account, joins the class");
  EXPECT_THAT(row(table(), 3)[4].toStdString(), testing::HasSubstr("not an e-mail address"));
  EXPECT_THAT(row(table(), 4)[4].toStdString(), testing::HasSubstr("person is the same as in line 2"));
  EXPECT_TRUE(words().startsWith("1 new   ·   1 join   ·   0 there already   ·   3 refused")) << words().toStdString();
  EXPECT_EQ(button("listGo").text(), "Add 2 people");
  EXPECT_TRUE(table().item(0, 1)->toolTip().contains("<b>")) << "as it is: no tooltip is rich text (HostileTextsTest)";

  button("listGo").click();
  ASSERT_TRUE(waitUntil([&] { return button("listSave").isVisible(); })) << words().toStdString();
  const QString shown = row(table(), 0)[4];
  ASSERT_TRUE(shown.startsWith("✓  first password: ")) << shown.toStdString();
  auto* members = people_->findChild<QTableWidget*>("peopleTable");
  EXPECT_TRUE(waitUntil([&] { return members->rowCount() == 2; })) << "the window behind has them";

  // They are not shown again: who closes is asked.
  button("listClose").click();
  QDialog* question = dialogWith("entryGo");
  EXPECT_TRUE(dialog_->isVisible());
  auto* saves = question->findChild<QPushButton*>("listSaveFirst");
  ASSERT_TRUE(saves);
  EXPECT_TRUE(saves->isDefault() && question->focusWidget() == saves) << "Enter loses no password";
  EXPECT_FALSE(question->findChild<QPushButton*>("entryGo")->isDefault());
  question->reject();
  const QString file = home.filePath("first.csv");
  test::answerFileDialog(*dialog_, file);
  button("listSave").click();
  ASSERT_TRUE(words().startsWith("Saved as")) << words().toStdString();
  QFile passwords(file);
  ASSERT_TRUE(passwords.open(QFile::ReadOnly));
  const QString password = shown.section(": ", 1);
  EXPECT_TRUE(QString::fromUtf8(passwords.readAll()).contains(password));
  EXPECT_EQ(passwords.permissions() & (QFile::ReadGroup | QFile::ReadOther), 0);
  QPointer<QDialog> gone = dialog_;
  button("listClose").click();
  EXPECT_TRUE(waitUntil([&] { return !gone; }));
  people_->close();
  signOut();
  signIn("zoe", password);
  ASSERT_TRUE(waitUntil([&] { return account().isSignedIn(); }));
  EXPECT_TRUE(account().mustChangePassword());
  EXPECT_TRUE(header().replace("&&", "&").startsWith(hostile.left(15))) << header().toStdString();
}

TEST_F(ClassListWindow, WhatIsNoListIsSaidAndChangesNothing) {
  const std::pair<QByteArray, const char*> lists[]{
      {"", "is empty"},
      {"Full name,Username\n", "no people"},
      {"Colour,Size\nred,4\n", "has no names"},
      {QByteArray("\xFF\xFE"
                  "F\0u\0",
                  6),
       "UTF-16"},
      {QByteArray("Full name,Username\nA\0b,ab\n", 26), "no table in text"},
      {"Full name,Username\n\"Ada,ada\n", "never closed"}};
  for (const auto& [list, said] : lists) {
    drop(list);
    EXPECT_THAT(words().toStdString(), testing::HasSubstr(said));
    EXPECT_EQ(table().rowCount(), 0) << said;
    EXPECT_FALSE(button("listGo").isEnabled()) << said;
  }
}

TEST_F(ClassListWindow, AListThatNoLongerFitsAddsNobody) {
  drop("Full name\tUsername\nZoe\tzoe\nYan\tyan\n");
  ASSERT_TRUE(asked<Person>([](const SignedIn& by) { return PeopleStore(by).add({"yan"}, "a first password"); }));
  button("listGo").click();
  ASSERT_TRUE(waitUntil([&] { return words().contains("Nobody was added"); })) << words().toStdString();
  EXPECT_FALSE(button("listSave").isVisible());
  const auto people = asked<std::vector<Person>>([](const SignedIn& by) { return PeopleStore(by).all(); });
  EXPECT_EQ(people->size(), 2U);
}

TEST_F(ClassListWindow, EnterPressesTheButtonThatHasTheFocus) {
  QFile list(home.filePath("chosen.csv"));
  ASSERT_TRUE(list.open(QFile::WriteOnly));
  list.write("Full name,Username\nZoe,zoe\n");
  list.close();
  test::answerFileDialog(*dialog_, list.fileName());
  button("listChoose").setFocus();
  QTest::keyClick(&button("listChoose"), Qt::Key_Return);
  EXPECT_TRUE(waitUntil([&] { return words().startsWith("1 new"); })) << words().toStdString();
  EXPECT_TRUE(button("listGo").isDefault());
}

TEST_F(ClassListWindow, EverythingHasANameAndATooltip) {
  drop("Full name,Username\nZoe,zoe\n");
  EXPECT_GT(test::expectNames(dialog_, true), 4);
  EXPECT_GT(test::expectNames(people_, true), 12);
}

}  // namespace
