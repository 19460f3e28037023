#include "Classroom.h"
#include "class/ClassTable.h"

#include <unit/curriculum/PostgresServer.h>

#include <QElapsedTimer>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTableWidget>
#include <QTimer>
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
    beat_.setInterval(1);
    QObject::connect(&beat_, &QTimer::timeout, [this] { longest_ms_ = std::max(longest_ms_, since_.restart()); });
  }
  void TearDown() override {
    Classroom::TearDown();
    store_.reset(), school_.reset();
  }
  QString file() const override { return address_; }
  void refresh() {
    desk().refresh();
    settle();
  }
  ClassDesk& desk() { return *workspace_->findChild<ClassDesk*>(); }
  QString words() { return child<QLabel>("classWords")->text(); }
  void startBeat() {
    beat_.start();
    since_.start();
    longest_ms_ = 0;
  }

  test::PostgresServer* server_ = nullptr;
  QString address_;
  QTimer beat_;
  QElapsedTimer since_;
  qint64 longest_ms_ = 0;
};

TEST_F(ServerAway, EachPageSaysSoAndComesBackByItself) {
  enter("ina");
  auto& table = *child<QTableView>("classTable");
  ASSERT_EQ(table.model()->rowCount(), 2);
  startBeat();
  server_->crash();
  refresh();
  EXPECT_TRUE(words().contains("cannot be reached")) << words().toStdString();
  EXPECT_TRUE(words().contains("try again")) << "and what to do";
  EXPECT_FALSE(words().contains("a b/c@d:e")) << "no password";
  EXPECT_TRUE(isSeen("classWords"));
  for (const char* tab : {"personTab", "compareTab", "recordingsTab", "ratersTab", "classTab"}) {
    child<QToolButton>(tab)->click();
    settle();
  }
  EXPECT_LT(longest_ms_, 1000) << "the window's thread waits for no server";

  server_->start();
  refresh();
  EXPECT_TRUE(isSeen("classTable")) << words().toStdString();
  EXPECT_EQ(table.model()->rowCount(), 2);
  EXPECT_TRUE(account_->isSignedIn()) << "nobody has to sign in again";
}

}  // namespace
}  // namespace insonate::review
