#include "server/Browser.h"
#include "server/ChildProcess.h"
#include "server/InventedSite.h"
#include "server/MadeUpWorkstation.h"
#include "server/ServerProgram.h"
#include "server/VideoCost.h"

#include <insonate/bench/ServerBench.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/SiteVerification.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <ctime>
#include <map>
#include <memory>
#include <mutex>
#include <random>
#include <thread>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using bench::Browser;
using bench::InventedSite;
using bench::MadeUpClass;
using bench::MadeUpWorkstation;
using bench::ServerProgram;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

double secondsSince(Clock::time_point begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// A folder for temporary files, which is deleted at the end.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "insonate-bench-XXXXXX").string();
    if (::mkdtemp(name.data())) path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Times of requests by kind. For any thread.
class Timings {
 public:
  void add(const std::string& request, const Result<bench::Answer>& answer) {
    const std::lock_guard lock(mutex_);
    Kind& kind = kinds_[request];
    constexpr int kServerError = 500;
    if (answer && answer->status < kServerError)
      kind.times_ms.push_back(answer->time_ms);
    else
      ++kind.failures;
  }
  std::vector<ServerBenchRow> rows() const {
    const std::lock_guard lock(mutex_);
    std::vector<ServerBenchRow> rows;
    for (const auto& [name, kind] : kinds_) {
      const auto at = [&times = kind.times_ms](double share) { return quantile(times, share).value_or(0); };
      rows.push_back({.request = name,
                      .count = static_cast<std::int64_t>(kind.times_ms.size()) + kind.failures,
                      .failures = kind.failures,
                      .p50_ms = at(0.5),
                      .p95_ms = at(0.95),
                      .p99_ms = at(0.99),
                      .max_ms = at(1)});
    }
    return rows;
  }

 private:
  struct Kind {
    std::vector<double> times_ms{};
    std::int64_t failures = 0;
  };
  mutable std::mutex mutex_;
  std::map<std::string, Kind> kinds_;
};

struct Load {
  const ServerLoad& plan;
  InventedSite site;
  std::vector<std::unique_ptr<ServerProgram>> servers;
  std::vector<MadeUpWorkstation> workstations;
  Timings timings{};
  std::atomic<bool> isOver = false;
  std::atomic<std::int64_t> events = 0, brokenStreams = 0, acknowledged = 0;
  std::vector<char> isAcknowledged{};  ///< of each workstation; written by the workstation's thread

  const std::string& urlOf(std::size_t client) const { return servers[client % servers.size()]->url(); }
  /// Waits, unless the load ends before.
  void pause(double seconds) {
    std::unique_lock lock(mutex);
    wake.wait_for(lock, std::chrono::duration<double>(seconds), [this] { return isOver.load(); });
  }
  void end() {
    const std::lock_guard lock(mutex);
    isOver = true;
    wake.notify_all();
  }

  std::mutex mutex{};
  std::condition_variable wake{};
};

/// A page for one user, and its kind as the report names it.
struct PageVisit {
  std::string kind, path;
};

std::vector<PageVisit> pagesOf(const MadeUpClass& one, bool isInstructor, std::mt19937& random) {
  if (!isInstructor) return {{"own training", "/me"}};
  const auto& trainee = one.trainees[random() % one.trainees.size()];
  return {{"list of classes", "/classes"},
          {"class with heat map", "/classes/" + one.id},
          {"trainee with learning curve", "/classes/" + one.id + "/people/" + trainee.id}};
}

std::string attemptIn(const std::string& page) {
  const std::size_t begin = page.find("/attempts/");
  return begin == std::string::npos ? "" : page.substr(begin, page.find('"', begin) - begin);
}

/// Signs in until it succeeds, as a person does while a server starts.
bool signIn(Load& load, Browser& browser, const std::string& name) {
  while (!load.isOver) {
    if (browser.signIn(name, bench::kMadeUpPassword)) return true;
    load.pause(1);
  }
  return false;
}

/// Instructors of all classes first, then trainees.
std::string userOf(const Load& load, std::size_t client, bool isInstructor) {
  const MadeUpClass& one = load.site.classes[client % load.site.classes.size()];
  return isInstructor ? one.instructor : one.trainees[client / load.site.classes.size() % one.trainees.size()].name;
}

/// Half of the readers are instructors.
void read(Load& load, std::size_t client) {
  constexpr double kPerPage_s = 5;
  const bool isInstructor = client % 2 == 0;
  std::mt19937 random(static_cast<unsigned>(client));
  Browser browser(load.urlOf(client), static_cast<int>(client) + 1);
  if (!signIn(load, browser, userOf(load, client, isInstructor))) return;
  load.pause(std::uniform_real_distribution(0.0, kPerPage_s)(random));
  const MadeUpClass& one = load.site.classes[client % load.site.classes.size()];
  while (!load.isOver) {
    for (const PageVisit& visit : pagesOf(one, isInstructor, random)) {
      const auto answer = browser.get(visit.path);
      load.timings.add(visit.kind, answer);
      load.pause(kPerPage_s);
      const std::string attempt = answer ? attemptIn(answer->body) : "";
      if (attempt.empty() || load.isOver) continue;
      load.timings.add("attempt", browser.get(attempt));
      load.pause(kPerPage_s);
    }
  }
}

std::string eventsIn(const std::string& page) {
  const std::string mark = "data-events=\"";
  const std::size_t begin = page.find(mark);
  if (begin == std::string::npos) return {};
  return page.substr(begin + mark.size(), page.find('"', begin + mark.size()) - begin - mark.size());
}

/// An open page: half are pages of a class, half a trainee's own.
void follow(Load& load, std::size_t client) {
  const bool isInstructor = client % 2 == 0;
  Browser browser(load.urlOf(client), static_cast<int>(client) + 1001);
  // People do not open their pages in the same second.
  load.pause(load.plan.duration_s / 10 * static_cast<double>(client) / std::max(1, load.plan.livePages));
  if (!signIn(load, browser, userOf(load, client, isInstructor))) return;
  const std::string path =
      isInstructor ? "/classes/" + load.site.classes[client % load.site.classes.size()].id : std::string("/me");
  std::string stream;
  const auto show = [&](bool isRefresh) {
    const auto answer = isRefresh ? browser.refresh(path) : browser.get(path);
    load.timings.add(isRefresh ? "page refreshed by a change" : "page opened", answer);
    if (answer && answer->status == 200) stream = eventsIn(answer->body);
  };
  const std::function<void()> changed = [&] {
    ++load.events;
    show(true);
  };
  while (!load.isOver) {
    if (stream.empty()) show(false);
    if (!stream.empty() && browser.follow(stream, changed, load.isOver) == 0 && !load.isOver) ++load.brokenStreams;
    load.pause(stream.empty() ? 5 : 3);  // as browsers do
  }
}

/// Sends the attempts whose time has come, until all are acknowledged.
void sendAttempts(Load& load, std::atomic<std::size_t>& next, Clock::time_point begun) {
  const std::size_t count = load.workstations.size();
  const double interval_s = load.plan.duration_s / static_cast<double>(count);
  for (std::size_t i = next++; i < count && !load.isOver; i = next++) {
    load.pause(interval_s * static_cast<double>(i) - secondsSince(begun));
    // Behind a proxy, a request goes to another server when the first one is down.
    for (std::size_t attempt = 0; !load.isOver; ++attempt) {
      const auto time_ms = load.workstations[i].send(load.urlOf(i + attempt), load.site.tokens[i]);
      if (time_ms) {
        load.timings.add("workstation sends an attempt", bench::Answer{.time_ms = *time_ms});
        load.isAcknowledged[i] = 1;
        ++load.acknowledged;
        break;
      }
      load.timings.add("workstation sends an attempt", tl::unexpected(time_ms.error()));
      load.pause(1);
    }
  }
}

/// Repeats a command that failed, since it may have killed the database and then failed to start it.
Result<void> crashDatabase(Load& load) {
  constexpr int kTries = 10;
  Result<void> crashed = bench::runInShell(load.plan.crashDatabase);
  for (int i = 1; i < kTries && !crashed && !load.isOver; ++i) {
    load.pause(1);
    crashed = bench::runInShell(load.plan.crashDatabase);
  }
  return crashed;
}

/// Kills the servers in turn, and crashes the database after every second kill.
Result<void> killServers(Load& load, ServerBench& bench, Clock::time_point begun) {
  const ServerLoad& plan = load.plan;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> moment(0.2, 1.0);
  const double interval_s = plan.kills > 0 ? plan.duration_s / plan.kills : 0;
  for (int i = 0; i < plan.kills && !load.isOver; ++i) {
    load.pause(interval_s * (i + moment(random)) - secondsSince(begun));
    ServerProgram& server = *load.servers[static_cast<std::size_t>(i) % load.servers.size()];
    server.kill();
    ++bench.kills;
    if (!plan.crashDatabase.empty() && i % 2 == 1) {
      if (auto crashed = crashDatabase(load); !crashed) return crashed;
      ++bench.crashes;
    }
    if (auto started = server.start(); !started) return started;
  }
  return {};
}

double processorOf(const Load& load) {
  double sum_s = 0;
  for (const auto& server : load.servers) sum_s += server->processor_s();
  return sum_s;
}

/// Applies the load for its duration, and longer until all attempts are acknowledged.
Result<void> applyLoad(Load& load, ServerBench& bench, const Progress& progress) {
  constexpr std::size_t kSenders = 8;
  const auto begun = Clock::now();
  const double before_s = processorOf(load);
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> threads;
  for (std::size_t i = 0; i < static_cast<std::size_t>(load.plan.readers); ++i)
    threads.emplace_back([&load, i] { read(load, i); });
  for (std::size_t i = 0; i < static_cast<std::size_t>(load.plan.livePages); ++i)
    threads.emplace_back([&load, i] { follow(load, i); });
  for (std::size_t i = 0; i < kSenders; ++i) threads.emplace_back([&] { sendAttempts(load, next, begun); });
  Result<void> killed;
  std::atomic<bool> killing = true;
  threads.emplace_back([&] { killed = killServers(load, bench, begun), killing = false; });

  const VerificationQueue queue(load.site.store);
  const auto all = static_cast<std::int64_t>(load.workstations.size());
  bool isCancelled = false;
  while (!isCancelled && (secondsSince(begun) < load.plan.duration_s || load.acknowledged < all || killing)) {
    std::this_thread::sleep_for(1s);
    bench.maxWaiting = std::max(bench.maxWaiting, queue.waiting().value_or(0));
    const double share = std::min(1.0, secondsSince(begun) / load.plan.duration_s);
    isCancelled = !report(progress, "load", share) || (!killing && !killed);
  }
  load.end();
  threads.clear();
  bench.measured_s = secondsSince(begun);
  bench.processor_s = processorOf(load) - before_s;
  if (!killed) return killed;
  return isCancelled ? Result<void>(fail(std::string(kCancelled))) : Result<void>();
}

/// An attempt that a killed server had taken is taken again after two minutes.
Result<void> waitForVerification(const Load& load, ServerBench& bench, const Progress& progress) {
  constexpr double kLongest_s = 1800;
  const VerificationQueue queue(load.site.store);
  const auto begun = Clock::now();
  while (secondsSince(begun) < kLongest_s) {
    const auto waiting = queue.waiting();
    if (!waiting) return tl::unexpected(waiting.error());
    bench.drained_s = secondsSince(begun);
    if (*waiting == 0) return {};
    if (!report(progress, "verification", std::min(1.0, bench.drained_s / kLongest_s)))
      return fail(std::string(kCancelled));
    std::this_thread::sleep_for(500ms);
  }
  return {};
}

void countAttempts(const Load& load, ServerBench& bench) {
  const AttemptStore attempts(load.site.administrator);
  for (std::size_t i = 0; i < load.workstations.size(); ++i) {
    if (!load.isAcknowledged[i]) continue;
    ++bench.acknowledged;
    const auto kept = attempts.attempt(load.workstations[i].attempt());
    const auto hash = kept && !kept->recordingFile.empty() ? recordingHash(kept->recordingFile) : fail("");
    if (!hash || *hash != load.workstations[i].recordingHash()) {
      ++bench.lost;
      continue;
    }
    if (kept->facts.proof == AttemptProof::Proven) ++bench.verified;
    if (kept->facts.proof == AttemptProof::Unproven) ++bench.refused;
  }
}

Result<void> startServers(Load& load, const fs::path& folder, const std::string& database) {
  for (int i = 0; i < load.plan.servers; ++i) {
    load.servers.push_back(std::make_unique<ServerProgram>(
        load.plan.server,
        std::vector<std::string>{"--database", database, "--recordings", (folder / "recordings").string()},
        folder / ("server-" + std::to_string(i + 1) + ".log")));
    if (auto started = load.servers.back()->start(); !started) return started;
  }
  return {};
}

/// Records a short attempt, and determines from it how long an attempt must be for the wanted size, and what its
/// verification costs.
Result<void> measureRecording(const Load& load, const fs::path& folder, ServerBench& bench) {
  constexpr double kTrial_s = 60, kShortest_s = 15;
  const std::string name = "workstation " + std::to_string(load.plan.workstations + 1);
  MadeUpWorkstation trial(folder / name, name);
  const std::string& trainee = load.site.classes.front().trainees.front().name;
  if (auto made = trial.prepare(load.urlOf(0), load.site.tokens.back(), trainee, load.site.curriculum, kTrial_s, 0);
      !made)
    return made;
  std::error_code failed;
  const double size_MB = static_cast<double>(fs::file_size(trial.recording(), failed)) / 1e6;
  if (failed) return fail(trial.recording().string() + ": " + failed.message() + ".");
  bench.recording_s = std::max(kShortest_s, kTrial_s * load.plan.recording_MB / size_MB);
  const std::clock_t before = std::clock();
  if (const auto facts = factsOfRecording(trial.recording()); !facts) return tl::unexpected(facts.error());
  const double replay_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  bench.verification_s = replay_s * bench.recording_s / kTrial_s;
  return {};
}

/// Names of trainees of all classes by turns, so that the attempts are spread over the classes.
std::vector<std::string> traineesByTurns(const InventedSite& site) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < site.classes.front().trainees.size(); ++i)
    for (const MadeUpClass& one : site.classes)
      if (i < one.trainees.size()) names.push_back(one.trainees[i].name);
  return names;
}

/// Each workstation with the attempt that it will send. More threads than cores, since a recorder writes only each 20
/// ms and its thread waits for it meanwhile.
Result<void> prepareWorkstations(Load& load, const fs::path& folder, ServerBench& bench, const Progress& progress) {
  if (auto measured = measureRecording(load, folder, bench); !measured) return measured;
  const std::vector<std::string> trainees = traineesByTurns(load.site);
  const auto count = static_cast<std::size_t>(load.plan.workstations);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string name = "workstation " + std::to_string(i + 1);
    load.workstations.emplace_back(folder / name, name);
  }
  load.isAcknowledged.resize(count, 0);
  std::vector<Result<void>> made(count);
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> isStopped = false;
  const auto prepare = [&] {
    for (std::size_t i = next++; i < count && !isStopped; i = next++) {
      made[i] = load.workstations[i].prepare(load.urlOf(i), load.site.tokens[i], trainees[i], load.site.curriculum,
                                             bench.recording_s, static_cast<unsigned>(i) + 1);
      ++done;
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < 6 * std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(prepare);
    while (done < count && !isStopped) {
      std::this_thread::sleep_for(200ms);
      isStopped = !report(progress, "recordings", static_cast<double>(done) / static_cast<double>(count));
    }
  }
  if (isStopped) return fail(std::string(kCancelled));
  for (const Result<void>& one : made)
    if (!one) return one;
  for (const MadeUpWorkstation& workstation : load.workstations) {
    std::error_code failed;
    bench.load_MB += static_cast<double>(fs::file_size(workstation.recording(), failed)) / 1e6;
  }
  return {};
}

}  // namespace

Result<ServerBench> runServerBench(const ServerLoad& plan, const Progress& progress) {
  const Folder folder;
  if (folder.path().empty()) return fail("The folder for temporary files cannot be written; name another in TMPDIR.");
  const std::string database = plan.database.empty() ? (folder.path() / "made-up.db").string() : plan.database;
  StoreServices services;
  services.passwordCost = PasswordCost::Minimum;
  services.recordings = folder.path() / "recordings";
  // The curriculum must have been published before the first attempts, which begin before they are sent.
  services.now_us = [] {
    const auto yesterday = std::chrono::system_clock::now() - std::chrono::hours(24);
    return std::chrono::duration_cast<std::chrono::microseconds>(yesterday.time_since_epoch()).count();
  };
  const auto store = CurriculumStore::open(database, services);
  if (!store) return tl::unexpected(store.error());
  const auto isUsed = store->hasPeople();
  if (!isUsed) return tl::unexpected(isUsed.error());
  if (*isUsed) return fail(store->place() + " is in use. Name an empty database, since the bench fills it.");
  auto site = bench::makeSite(*store, std::max(plan.trainees, plan.workstations), plan.workstations, progress);
  if (!site) return tl::unexpected(site.error());
  ServerBench bench{.load = plan, .database = plan.database.empty() ? "SQLite" : "PostgreSQL"};
  bench.trainees = site->trainees, bench.classes = static_cast<int>(site->classes.size());
  bench.earlierAttempts = site->attempts;
  Load load{.plan = plan, .site = std::move(*site), .servers = {}, .workstations = {}};
  if (auto started = startServers(load, folder.path(), database); !started) return tl::unexpected(started.error());
  if (auto made = prepareWorkstations(load, folder.path(), bench, progress); !made) return tl::unexpected(made.error());
  if (auto applied = applyLoad(load, bench, progress); !applied) return tl::unexpected(applied.error());
  if (auto waited = waitForVerification(load, bench, progress); !waited) return tl::unexpected(waited.error());
  countAttempts(load, bench);
  if (plan.withVideo) {
    const auto cost = bench::measureVideoCost(folder.path(), progress);
    if (!cost) return tl::unexpected(cost.error());
    bench.videoMinute_s = 60 * cost->processor_s / cost->attempt_s;
    bench.videoMinute_MB = 60 * cost->size_MB / cost->attempt_s;
  }
  bench.rows = load.timings.rows();
  bench.events = load.events, bench.brokenStreams = load.brokenStreams;
  for (const auto& server : load.servers) {
    bench.memory_MB = std::max(bench.memory_MB, server->memory_MB());
    bench.slowestStart_s = std::max(bench.slowestStart_s, server->slowestStart_s());
  }
  return bench;
}

}  // namespace insonate
