#include "Classroom.h"
#include "class/ClassTable.h"

#include <ui/support/Beat.h>
#include <unit/curriculum/PostgresServer.h>

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QToolButton>

namespace insonate::review {
namespace {

/// The class is kept on a server, which goes and comes back while the window is looked at.
class ServerAway : public Classroom {
 protected:
  void SetUp() override {
    server_ = test::PostgresServer::shared();
    if (!server_) GTEST_SKIP() << "PostgreSQL 15 is not installed";
    address_ = QString::fromStdString(server_->freshDatabase());
    Classroom::SetUp();
    practise(school_->as(school_->anna), true, 3);
  }
  void TearDown() override {
    Classroom::TearDown();
    store_.reset(), school_.reset();
    if (server_) server_->start();
  }
  QString file() const override { return address_; }
  void refresh() {
    controller().refresh();
    settle();
  }
  ClassController& controller() { return *workspace_->findChild<ClassController*>(); }
  QString words() { return child<QLabel>("classWords")->text(); }

  test::PostgresServer* server_ = nullptr;
  QString address_;
  test::Beat beat_;
};

TEST_F(ServerAway, EachPageSaysSoAndComesBackByItself) {
  enter("ina");
  auto& table = *child<QTableView>("classTable");
  ASSERT_EQ(table.model()->rowCount(), 2);
  beat_.start();
  server_->fallSilent();
  refresh();
  EXPECT_TRUE(words().contains("cannot be reached")) << words().toStdString();
  EXPECT_TRUE(words().contains("try again")) << "and what to do";
  EXPECT_FALSE(words().contains("a b/c@d:e")) << "no password";
  EXPECT_TRUE(isSeen("classWords"));
  for (const char* tab : {"personTab", "compareTab", "recordingsTab", "ratersTab", "classTab"}) {
    child<QToolButton>(tab)->click();
    settle();
  }
  // A silent server is waited for 10 s; a busy machine pauses a window for one.
  EXPECT_LT(beat_.longest_ms(), 3000) << "the window's thread waits for no server";

  server_->start();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isSeen("classTable"); }, kPatience_ms)) << words().toStdString();
  settle();
  EXPECT_EQ(table.model()->rowCount(), 2);
  EXPECT_TRUE(account_->isSignedIn()) << "nobody has to sign in again";
}

}  // namespace
}  // namespace insonate::review
