#include "WebRig.h"

#include <fstream>
#include <functional>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Breaks the database under a running server, and expects of each page that it says so and nothing else.
void expectUnavailable(const std::function<void(const std::string&)>& breakFile) {
  const StoreRig rig;
  const WebSchool school(rig.open());
  const std::string anna = school.signIn("anna");
  breakFile(rig.address);
  const auto expect = [&](const web::Response& response, const std::string& what) {
    EXPECT_EQ(response.status, 503) << what;
    EXPECT_THAT(response.body, AllOf(HasSubstr("database cannot be used"), Not(HasSubstr(rig.address)),
                                     Not(HasSubstr("curriculum.db")), Not(HasSubstr("SELECT"))))
        << what;
  };
  expect(school.get("/me", anna), "/me");
  expect(school.get("/attempts/" + school.annas, anna), "an attempt");
  expect(school.get("/sign-in"), "/sign-in");
  expect(school.post("/sign-in", {{"name", "anna"}, {"password", kPassword}}), "a right password");
  expect(school.post("/sign-in", {{"name", "anna"}, {"password", "wrong password"}}), "a wrong password");
  expect(school.post("/sign-out", {}, anna), "/sign-out");
  EXPECT_EQ(school.site.answer(WebSchool::fromHere("/health")).status, 503);
}

TEST(WebDatabaseFailure, ADeletedDatabaseIsSaidOnEachPage) {
  expectUnavailable([](const std::string& file) { std::filesystem::remove(file); });
}

TEST(WebDatabaseFailure, AnEmptiedDatabaseIsSaidOnEachPage) {
  expectUnavailable([](const std::string& file) { std::filesystem::resize_file(file, 0); });
}

TEST(WebDatabaseFailure, ADatabaseReplacedByJunkIsSaidOnEachPage) {
  expectUnavailable([](const std::string& file) {
    std::filesystem::remove(file);
    std::ofstream(file) << std::string(100'000, 'x');
  });
}

TEST(WebDatabaseFailure, JunkInTheDatabaseEndsRequestsOfNewThreads) {
  const StoreRig rig;
  const WebSchool school(rig.open());
  {
    std::fstream file(rig.address, std::ios::in | std::ios::out | std::ios::binary);
    file << std::string(std::filesystem::file_size(rig.address), 'x');
    std::filesystem::resize_file(rig.address + "-wal", 0);
  }
  std::thread([&] {
    const web::Response response = school.get("/sign-in");
    EXPECT_EQ(response.status, 503);
    EXPECT_THAT(response.body, AllOf(HasSubstr("database cannot be used"), Not(HasSubstr(rig.address))));
  }).join();
}

TEST(WebDatabaseFailure, AServerThatIsAwayIsSaidUntilItIsBack) {
  PostgresServer* server = PostgresServer::shared();
  if (!server) GTEST_SKIP() << "PostgreSQL 15 is not installed";
  const StoreRig rig(Place::Server);
  const WebSchool school(rig.open());
  const std::string anna = school.signIn("anna");
  server->crash();
  for (const web::Response& response :
       {school.get("/me", anna), school.post("/sign-in", {{"name", "anna"}, {"password", kPassword}})}) {
    EXPECT_EQ(response.status, 503);
    EXPECT_THAT(response.body,
                AllOf(HasSubstr("database cannot be used"), Not(HasSubstr("postgresql")), Not(HasSubstr("127.0.0.1"))));
  }
  server->start();
  EXPECT_EQ(school.get("/me", anna).status, 200) << "the session goes on";
}

TEST(WebDatabaseFailure, RefusalsAreNoFailures) {
  const StoreRig rig;
  const WebSchool school(rig.open());
  EXPECT_EQ(school.post("/sign-in", {{"name", "anna"}, {"password", "wrong password"}}).status, 401);
  EXPECT_EQ(school.get("/audit", school.signIn("anna")).status, 403);
}

}  // namespace
}  // namespace insonate::test
