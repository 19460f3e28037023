#include "StoreRig.h"
#include "store/sql/Dialect.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QtSql/QSqlDatabase>
#include <QtSql/QSqlQuery>
#include <functional>
#include <map>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::IsEmpty;

/// Another process of this workstation, which does something and then lives until it is killed.
class OtherProcess {
 public:
  explicit OtherProcess(const std::function<void()>& work) {
    int ends[2];
    if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
    child_ = ::fork();
    if (child_ == 0) {
      ::close(ends[0]);
      try {
        work();
        (void)!::write(ends[1], "+", 1);
        ::pause();
      } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
      }
      ::_exit(1);
    }
    ::close(ends[1]);
    done_ = ends[0];
  }
  ~OtherProcess() {
    kill();
    ::close(done_);
  }
  OtherProcess(const OtherProcess&) = delete;
  OtherProcess& operator=(const OtherProcess&) = delete;

  /// False: it failed.
  bool waitUntilDone() const {
    char mark = 0;
    return ::read(done_, &mark, 1) == 1;
  }
  void kill() {
    if (child_ <= 0) return;
    ::kill(child_, SIGKILL);
    ::waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  pid_t child_ = 0;
  int done_ = -1;
};

/// A file that another process lengthens as it gets on.
class Progress {
 public:
  explicit Progress(std::filesystem::path file) : file_(std::move(file)) { std::ofstream made(file_); }

  /// Appended at once, so that a kill leaves whole lines.
  void say(const std::string& line) const {
    const int file = ::open(file_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
    const std::string ended = line + "\n";
    const bool whole = ::write(file, ended.data(), ended.size()) == static_cast<ssize_t>(ended.size());
    ::close(file);
    if (!whole) throw std::runtime_error("progress cannot be written");
  }
  std::uintmax_t length() const { return std::filesystem::file_size(file_); }
  /// False: not within a minute.
  bool waitUntilLongerThan(std::uintmax_t bytes) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (length() <= bytes && std::chrono::steady_clock::now() < end)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return length() > bytes;
  }
  std::vector<std::string> lines() const {
    std::ifstream in(file_);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
  }

 private:
  std::filesystem::path file_;
};

/// Starts work again and again, and kills it at another moment each time: at first while it opens the store
/// and signs in, then after it has got on, however slow the machine is.
void killAgainAndAgain(const Progress& progress, const std::function<void()>& work) {
  for (int round = 0; round < 12; ++round) {
    const std::uintmax_t before = progress.length();
    OtherProcess worker(work);
    ASSERT_TRUE(round < 5 || progress.waitUntilLongerThan(before)) << "round " << round;
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 37 * round));
  }
}

/// Processes are forked before their parent opens anything: connections do not survive a fork.
class StoreCrash : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    OtherProcess first([&] { School school(rig->open()); });
    ASSERT_TRUE(first.waitUntilDone());
  }
  SignedIn as(const std::string& name) const { return valueOf(rig->open().signIn(name, kPassword)); }
};
INSONATE_ON_BOTH(StoreCrash);

TEST_P(StoreCrash, AnAttemptIsToldAbandonedOnceItsProcessHasDied) {
  const AttemptFacts facts = begunFacts();
  OtherProcess other([&] { valueOf(AttemptStore(as("anna")).begin(facts)); });
  ASSERT_TRUE(other.waitUntilDone());
  EXPECT_EQ(valueOf(AttemptStore(as("anna")).attempt(facts.id)).facts.state, AttemptState::Open) << "it lives";
  other.kill();

  StoreServices elsewhere = rig->services;
  elsewhere.workstation = "ward 8";
  (void)valueOf(CurriculumStore::open(rig->address, elsewhere));
  const SignedIn admin = as("admin");
  const StoredAttempt kept = valueOf(AttemptStore(admin).attempt(facts.id));
  EXPECT_EQ(kept.facts.state, AttemptState::Abandoned);
  EXPECT_TRUE(kept.crashed);

  const SignedIn anna = as("anna");
  AttemptFacts late = endedFacts(facts);
  late.state = AttemptState::Abandoned;
  succeed(AttemptStore(anna).end(late));
  EXPECT_EQ(valueOf(AttemptStore(anna).attempt(facts.id)).facts.points, late.points)
      << "its recording told more, later";
  EXPECT_FALSE(valueOf(AttemptStore(anna).attempt(facts.id)).crashed);
  EXPECT_FALSE(AttemptStore(anna).end(endedFacts(facts))) << "once";
}

TEST_P(StoreCrash, AnotherWorkstationLeavesItOpen) {
  const AttemptFacts facts = begunFacts();
  OtherProcess other([&] { valueOf(AttemptStore(as("anna")).begin(facts)); });
  ASSERT_TRUE(other.waitUntilDone());
  other.kill();
  rig->services.workstation = "ward 8";
  EXPECT_EQ(valueOf(AttemptStore(as("anna")).attempt(facts.id)).facts.state, AttemptState::Open);
  rig->services.workstation = "ward 7";
  EXPECT_EQ(valueOf(AttemptStore(as("anna")).attempt(facts.id)).facts.state, AttemptState::Abandoned);
}

TEST_P(StoreCrash, NothingThatWasSaidToBeKeptIsLostByKillsInTheMiddleOfEverything) {
  const Progress voided(rig->folder / "voided");
  killAgainAndAgain(voided, [&] {
    const SignedIn anna = as("anna"), ina = as("ina");
    for (;;) {
      const AttemptFacts facts = keepAttempt(anna);
      succeed(AttemptStore(ina).voidAttempt(facts.id, "device failed"));
      voided.say(facts.id);
    }
  });

  const SignedIn admin = as("admin"), anna = as("anna");
  succeed(StoreUpkeep(admin).verify());
  EXPECT_FALSE(voided.lines().empty());
  for (const std::string& id : voided.lines())
    EXPECT_EQ(valueOf(AttemptStore(anna).attempt(id)).facts.state, AttemptState::Voided) << id;
  int open = 0;
  for (const AttemptFacts& facts : valueOf(AttemptStore(anna).history(anna.person().id)))
    open += facts.state == AttemptState::Open;
  EXPECT_EQ(open, 0) << "all of the dead are told abandoned";
}

TEST_P(StoreCrash, AnUploadThatIsKilledLosesAndDoublesNothing) {
  StoreRig ward;
  const Progress uploads(rig->folder / "uploads");
  killAgainAndAgain(uploads, [&] {
    const CurriculumStore near = ward.open(), server = rig->open();
    for (;;) {
      valueOf(SiteUpload(near, server).exchange());
      uploads.say("done");
      const SignedIn anna = valueOf(near.signIn("anna", kPassword));
      for (int i = 0; i < 5; ++i) keepAttempt(anna);
    }
  });

  const CurriculumStore near = ward.open();
  EXPECT_THAT(valueOf(SiteUpload(near, rig->open()).exchange()).errors, IsEmpty());
  const SignedIn there = as("anna"), here = valueOf(near.signIn("anna", kPassword));
  const auto statesById = [](const SignedIn& anna) {
    std::map<std::string, AttemptState> states;
    for (const AttemptFacts& facts : valueOf(AttemptStore(anna).history(anna.person().id)))
      EXPECT_TRUE(states.emplace(facts.id, facts.state).second);
    return states;
  };
  EXPECT_FALSE(statesById(here).empty());
  EXPECT_EQ(statesById(there), statesById(here));
  succeed(StoreUpkeep(as("admin")).verify());
}

TEST_P(StoreCrash, TwoWorkstationsAtOnceGetNumbersOfTheirOwnAndLoseNothing) {
  constexpr int kEach = 40;
  const auto work = [&](const std::string& name) {
    return [&, name] {
      for (int i = 0; i < kEach; ++i) {
        const SignedIn by = as(name);
        keepAttempt(by);
      }
    };
  };
  {
    OtherProcess one(work("anna")), two(work("ben"));
    EXPECT_TRUE(one.waitUntilDone());
    EXPECT_TRUE(two.waitUntilDone());
  }
  const SignedIn admin = as("admin");
  EXPECT_EQ(valueOf(StoreUpkeep(admin).facts()).attempts, 2 * kEach);
  succeed(StoreUpkeep(admin).verify());
}

TEST_P(StoreCrash, ThreadsHaveConnectionsOfTheirOwn) {
  const CurriculumStore store = rig->open();
  const SignedIn anna = valueOf(store.signIn("anna", kPassword));
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      for (int j = 0; j < 10; ++j) keepAttempt(anna);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(valueOf(AttemptStore(anna).history(anna.person().id)).size(), 40U);
}

class StoreOnNewFile : public OnBoth {};
INSONATE_ON_BOTH(StoreOnNewFile);

TEST_P(StoreOnNewFile, ManyProcessesThatComeAtOnceMakeOneStore) {
  const auto open = [&] { (void)rig->open(); };
  OtherProcess a(open), b(open), c(open), d(open);
  for (const OtherProcess* process : {&a, &b, &c, &d}) EXPECT_TRUE(process->waitUntilDone());
  EXPECT_FALSE(valueOf(rig->open().hasPeople()));
}

TEST_P(StoreOnNewFile, AKillWhileItIsMadeLeavesAllOrNothing) {
  for (int round = 0; round < 12; ++round) {
    OtherProcess other([&] { (void)rig->open(); });
    std::this_thread::sleep_for(std::chrono::milliseconds(2 * round));
  }
  const School school(rig->open());
  succeed(StoreUpkeep(school.admin).verify());
}

TEST_P(StoreOnNewFile, OneAdministratorIsFirst) {
  const auto first = [&](const std::string& name) {
    return [&, name] { valueOf(rig->open().createFirstAdministrator({name}, kPassword)); };
  };
  OtherProcess a(first("one")), b(first("two"));
  EXPECT_NE(a.waitUntilDone(), b.waitUntilDone());
}

/// The database driver itself reports a database that may not grow.
TEST(StoreOnFullDisk, IsNamedAsSuch) {
  const TemporaryFolder folder;
  const auto file = (folder / "full.sqlite").string();
  QSqlError error;
  {
    QSqlDatabase database = QSqlDatabase::addDatabase(QStringLiteral("QSQLITE"), QStringLiteral("full"));
    database.setDatabaseName(QString::fromStdString(file));
    ASSERT_TRUE(database.open());
    QSqlQuery query(database);
    ASSERT_TRUE(query.exec(QStringLiteral("CREATE TABLE large (bytes BLOB)")));
    ASSERT_TRUE(query.exec(QStringLiteral("PRAGMA max_page_count = 3")));
    EXPECT_FALSE(query.exec(QStringLiteral("INSERT INTO large VALUES (zeroblob(1000000))")));
    error = query.lastError();
  }
  QSqlDatabase::removeDatabase(QStringLiteral("full"));
  EXPECT_EQ(store::findingText(error, file).message,
            "The disk with " + file + " is full. Nothing was stored; free space and try again.");
}

/// No disk has to be full for it: the process may not write a larger file.
TEST(StoreOnFullDisk, RefusesWithASentenceAndKeepsWhatItHad) {
  StoreRig rig;
  OtherProcess first([&] {
    const School school(rig.open());
    keepAttempt(school.as(school.anna));
  });
  ASSERT_TRUE(first.waitUntilDone());
  OtherProcess writer([&] {
    ::signal(SIGXFSZ, SIG_IGN);
    const SignedIn anna = valueOf(rig.open().signIn("anna", kPassword));
    const auto size = std::filesystem::file_size(rig.address);
    const rlimit limit{size + 20'000, size + 20'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    std::string refusal;
    for (int i = 0; i < 1000 && refusal.empty(); ++i) {
      AttemptFacts facts = begunFacts();
      facts.level = std::string(1000, 'x');
      if (const auto begun = AttemptStore(anna).begin(facts); !begun) refusal = begun.error().message;
    }
    if (refusal.find("Nothing was stored") == std::string::npos) throw std::runtime_error("refused by: " + refusal);
    if (!AttemptStore(anna).history(anna.person().id)) throw std::runtime_error("cannot be read any more");
  });
  EXPECT_TRUE(writer.waitUntilDone());
  writer.kill();
  first.kill();
  const CurriculumStore store = rig.open();
  const SignedIn admin = valueOf(store.signIn("admin", kPassword));
  succeed(StoreUpkeep(admin).verify());
  EXPECT_TRUE(AttemptStore(valueOf(store.signIn("anna", kPassword))).begin(begunFacts()))
      << "and goes on where there is room";
}

}  // namespace
}  // namespace insonate::test
