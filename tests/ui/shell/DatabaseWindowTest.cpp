#include "AccountWindow.h"

#include <gtest/gtest.h>
#include <support/TestData.h>

#include <QClipboard>
#include <QGuiApplication>
#include <QLineEdit>
#include <QTableWidget>

namespace {

using namespace insonate;
using test::waitUntil;

/// The window of the database, for one person alone, who is the administrator.
class DatabaseWindow : public test::AccountWindow {
 protected:
  void SetUp() override {
    AccountWindow::SetUp();
    std::optional<bool> done;
    account().setUpAlone("Ada Min", test::kAccountPassword,
                         [&](const Result<void>& result) { done = result.has_value(); });
    ASSERT_TRUE(waitUntil([&] { return done && account().isSignedIn(); }));
    ASSERT_TRUE(action("accountDatabase").isVisible());
    action("accountDatabase").trigger();
    ASSERT_TRUE(waitUntil([&] { return table("auditTable").rowCount() > 0; }));
  }

  template <class Widget>
  Widget& part(const char* name) {
    return *window->findChild<Widget*>(name);
  }
  QTableWidget& table(const char* name) { return part<QTableWidget>(name); }
  QString message() { return part<QLabel>("databaseMessage").text(); }
  void press(const char* button) { part<QPushButton>(button).click(); }
  int shownRows() {
    int rows = 0;
    for (int row = 0; row < table("auditTable").rowCount(); ++row) rows += !table("auditTable").isRowHidden(row);
    return rows;
  }
};

TEST_F(DatabaseWindow, ShowsAndSearchesTheAuditLog) {
  EXPECT_TRUE(waitUntil([&] { return part<QLabel>("databaseFacts").text().contains("1 people"); }));
  part<QLineEdit>("auditSearch").setText("create first");
  EXPECT_EQ(shownRows(), 1);
  part<QLineEdit>("auditSearch").setText("ada min");
  EXPECT_GE(shownRows(), 1) << "people are named";
  part<QLineEdit>("auditSearch").setText("no such entry");
  EXPECT_EQ(shownRows(), 0);
  EXPECT_FALSE(part<QPushButton>("auditEarlier").isEnabled()) << "all entries are shown";
}

TEST_F(DatabaseWindow, AnIntactDatabaseGivesAnAnchorThatLaterProvesTheLog) {
  press("databaseVerify");
  ASSERT_TRUE(waitUntil([&] { return message().startsWith("No difference was found."); })) << message().toStdString();
  const QString anchor = part<QLineEdit>("databaseAnchor").text();
  press("databaseCopyAnchor");
  EXPECT_EQ(QGuiApplication::clipboard()->text(), anchor);

  part<QLineEdit>("databaseEarlierAnchor").setText(anchor);
  press("databaseVerify");
  ASSERT_TRUE(waitUntil([&] { return part<QLineEdit>("databaseAnchor").text() != anchor; }));
  EXPECT_TRUE(message().startsWith("No difference was found."));

  part<QLineEdit>("databaseEarlierAnchor").setText("1:" + QString(64, '0'));
  press("databaseVerify");
  EXPECT_TRUE(waitUntil([&] { return message().startsWith("▲"); })) << message().toStdString();
  part<QLineEdit>("databaseEarlierAnchor").setText("nonsense");
  press("databaseVerify");
  EXPECT_TRUE(message().startsWith("▲")) << message().toStdString();
}

TEST_F(DatabaseWindow, BacksUpAndExports) {
  const QString backup = home.filePath("copy.sqlite"), all = home.filePath("all.json");
  test::answerFileDialog(*window, backup);
  press("databaseBackUp");
  ASSERT_TRUE(waitUntil([&] { return message().startsWith("Backed up to " + backup); })) << message().toStdString();
  EXPECT_TRUE(CurriculumStore::open(backup.toStdString())) << "the backup is a database";
  test::answerFileDialog(*window, all);
  press("databaseExport");
  ASSERT_TRUE(waitUntil([&] { return message().startsWith("Exported to " + all); })) << message().toStdString();
  const std::string text = test::bytesOf(all.toStdString());
  EXPECT_NE(text.find("Ada Min"), std::string::npos);
  EXPECT_EQ(text.find("argon2"), std::string::npos) << "no password, not even a hash";
  test::answerFileDialog(*window, home.filePath("no such folder/all.json"));
  press("databaseExport");
  EXPECT_TRUE(waitUntil([&] { return message().startsWith("▲"); })) << message().toStdString();
}

}  // namespace
