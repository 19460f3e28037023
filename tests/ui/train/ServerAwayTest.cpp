#include "LevelWindow.h"
#include "levels/AttemptSaver.h"

#include <ui/support/Beat.h>
#include <unit/curriculum/PostgresServer.h>

namespace insonate::train {
namespace {

/// The levels and attempts are kept on a server, which goes before an attempt begins and comes back after it ended.
class ServerAwayCourse : public LevelWindow {
 protected:
  void SetUp() override {
    server_ = test::PostgresServer::shared();
    if (!server_) GTEST_SKIP() << "PostgreSQL 15 is not installed";
    address_ = QString::fromStdString(server_->freshDatabase());
    LevelWindow::SetUp();
  }
  void TearDown() override {
    LevelWindow::TearDown();
    if (server_) server_->start();
  }
  QString storeFile() const override { return address_; }

  test::PostgresServer* server_ = nullptr;
  QString address_;
};

TEST_F(ServerAwayCourse, AnAttemptIsKeptHereAndHandedInByItselfOnceItIsBack) {
  // Not the status line, which does not change where the same sentence is said twice in a row.
  QStringList said;
  QObject::connect(workspace_->findChild<AttemptSaver*>(), &AttemptSaver::messageReported,
                   [&](const QString& sentence) { said << sentence; });
  signIn();
  levels_->choose("first");
  openWide();
  server_->fallSilent();
  makeAttempt();
  EXPECT_TRUE(text("levelVerdict").contains("Passed")) << "it counts here: " << text("levelVerdict").toStdString();
  ASSERT_TRUE(waitFor([&] { return !said.filter("kept on this computer and sent later").isEmpty(); }));
  EXPECT_FALSE(said.filter("cannot be reached").isEmpty());
  ASSERT_TRUE(waitFor([&] { return account_->isServerUnreachable(); }));
  EXPECT_EQ(unsent().size(), 1);

  said.clear();
  makeAttempt();
  ASSERT_TRUE(waitFor([&] { return unsent().size() == 2; }));
  ASSERT_TRUE(waitFor([&] { return said.filter("sent later").size() >= 2; })) << "as it begins and as it ends";

  key(Qt::Key_J);
  test::Beat beat;
  beat.start();
  course_->refresh();
  ASSERT_TRUE(waitFor([&] { return text("courseNote").contains("cannot be reached"); }));
  EXPECT_TRUE(child<QListWidget>("levels")->item(0)->text().contains("mastered")) << "what is known is shown";
  // A silent server is waited for 10 s; a busy machine pauses a window for one.
  EXPECT_LT(beat.longest_ms(), 3000) << "the window's thread waits for no server";

  server_->start();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty(); }));
  ASSERT_TRUE(waitFor([&] { return course_->error().isEmpty(); })) << course_->error().toStdString();
  const auto kept = stored();
  ASSERT_EQ(kept.size(), 2U);
  for (const StoredAttempt& one : kept) EXPECT_EQ(one.facts.state, AttemptState::Completed);
  EXPECT_EQ(kept[1].facts.proof, AttemptProof::Proven) << "its seal was asked for beforehand";
  EXPECT_EQ(kept[0].facts.proof, AttemptProof::Unproven) << "of this one nobody was asked";
  EXPECT_TRUE(account_->isSignedIn()) << "nobody has to sign in again";
}

TEST_F(ServerAwayCourse, AnAttemptThatWasBegunBeforeItWentIsEndedAfterIt) {
  signIn();
  levels_->choose("first");
  openWide();
  key(Qt::Key_Return, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return attempt_->isRunning() && unsent().isEmpty(); }));
  server_->crash();
  finish();
  ASSERT_TRUE(waitFor([&] { return account_->isServerUnreachable(); }));
  EXPECT_EQ(unsent().size(), 1);
  server_->start();
  ASSERT_TRUE(waitFor([&] { return unsent().isEmpty(); }));
  const auto kept = stored();
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].facts.state, AttemptState::Completed);
}

}  // namespace
}  // namespace insonate::train
