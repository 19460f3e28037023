#include "CurriculumBench.h"

#include "LevelPath.h"
#include "MetricSeries.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/teaching/MadeUpClass.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kPassword = "made up for a benchmark";

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A new folder for the store, which goes with this.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "insonate-bench-XXXXXX").string();
    if (::mkdtemp(name.data())) path_ = name;
  }
  ~Folder() {
    std::error_code error;
    if (!path_.empty()) fs::remove_all(path_, error);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Each query gives the number of its rows.
using Query = std::function<Result<std::size_t>(int round)>;

template <class List>
Result<std::size_t> sizeOf(const Result<List>& list) {
  return list ? Result<std::size_t>(list->size()) : tl::unexpected(list.error());
}

/// Asks, and keeps how long it took.
class Stopwatch {
 public:
  Stopwatch(CurriculumBench& bench, const Progress& progress, int rounds)
      : bench_(bench), progress_(progress), rounds_(rounds) {}

  Result<void> ask(const char* screen, const char* query, const Query& asked) {
    CurriculumBenchRow row{.screen = screen, .query = query, .rows = 0, .asked = rounds_};
    std::vector<double> times_ms;
    for (int round = 0; round < rounds_; ++round) {
      if (!report(progress_, query, static_cast<double>(round) / rounds_)) return fail(std::string(kCancelled));
      const auto begin = Clock::now();
      const auto rows = asked(round);
      times_ms.push_back(1e3 * secondsSince(begin));
      if (!rows) return tl::unexpected(rows.error());
      row.rows = std::max(row.rows, *rows);
    }
    row.p50_ms = quantile(times_ms, 0.5).value_or(0), row.p95_ms = quantile(times_ms, 0.95).value_or(0);
    row.max_ms = *std::ranges::max_element(times_ms);
    bench_.rows.push_back(std::move(row));
    return {};
  }

 private:
  CurriculumBench& bench_;
  const Progress& progress_;
  const int rounds_;
};

struct Seats {
  SignedIn teacher, trainee, administrator;
  Cohort cohort;
  std::vector<std::string> trainees;  ///< Person::id
  Curriculum curriculum;
};

Result<Seats> takeSeats(const CurriculumStore& store, const Curriculum& curriculum) {
  const auto teacher = store.signIn(kMadeUpTeacher, kPassword), trainee = store.signIn("made-up-001", kPassword),
             administrator = store.signIn(kMadeUpAdministrator, kPassword);
  for (const auto* by : {&teacher, &trainee, &administrator})
    if (!*by) return tl::unexpected(by->error());
  const auto cohorts = CohortStore(*teacher).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  const auto cohort = std::ranges::find(*cohorts, kMadeUpClass, &Cohort::name);
  const auto members = CohortStore(*teacher).members(cohort->id);
  if (!members) return tl::unexpected(members.error());
  Seats seats{*teacher, *trainee, *administrator, *cohort, {}, curriculum};
  for (const Member& member : *members)
    if (!member.teaches) seats.trainees.push_back(member.person.id);
  return seats;
}

Result<void> askAll(const Seats& seats, Stopwatch& watch) {
  const auto& [teacher, trainee, administrator, cohort, trainees, curriculum] = seats;
  const auto someone = [&](int round) { return trainees[static_cast<std::size_t>(round) % trainees.size()]; };
  const std::pair<std::pair<const char*, const char*>, Query> asked[]{
      {{"class overview", "people of a class with level and last attempt"},
       [&](int) { return sizeOf(CohortStore(teacher).members(cohort.id)); }},
      {{"class overview", "the last 10 attempts of each, for the heat map"},
       [&](int) { return sizeOf(AttemptStore(teacher).lastOfCohort(cohort.id, 10)); }},
      {{"student", "all attempts, for curves"},
       [&](int i) { return sizeOf(AttemptStore(teacher).history(someone(i))); }},
      {{"student", "a page of attempts, newest first"},
       [&](int i) { return sizeOf(AttemptStore(teacher).page(someone(i), 50)); }},
      {{"student", "all attempts and the path worked out from them"},
       [&](int i) { return sizeOf(levelPath(teacher, curriculum, someone(i))); }},
      {{"student", "forms"}, [&](int i) { return sizeOf(FormStore(teacher).ofPerson(someone(i))); }},
      {{"trainee", "own path of levels"},
       [&](int) { return sizeOf(levelPath(trainee, curriculum, trainee.person().id)); }},
      {{"trainee", "own attempts, newest first"},
       [&](int) { return sizeOf(AttemptStore(trainee).page(trainee.person().id, 50)); }},
      {{"curriculum", "published curricula"}, [&](int) { return sizeOf(PublishedCurricula(teacher).list()); }},
      {{"people", "everyone"}, [&](int) { return sizeOf(PeopleStore(administrator).all()); }},
      {{"people", "classes"}, [&](int) { return sizeOf(CohortStore(administrator).cohorts()); }},
      {{"audit log", "a page of the log"}, [&](int) { return sizeOf(AuditLog(administrator).page(100)); }}};
  for (const auto& [name, query] : asked)
    if (auto done = watch.ask(name.first, name.second, query); !done) return done;
  return {};
}

}  // namespace

Result<CurriculumBench> runCurriculumBench(bool quick, const Progress& progress) {
  const Folder folder;
  if (folder.path().empty()) return fail("The folder for temporary files cannot be written; name another in TMPDIR.");
  CurriculumBench bench{.trainees = quick ? 20 : 200, .attempts = quick ? 50 : 500, .rows = {}, .notes = {}};
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  StoreServices services;
  services.passwordCost = PasswordCost::Least;
  const auto store = CurriculumStore::open((folder.path() / "made-up.sqlite").string(), services);
  if (!store) return tl::unexpected(store.error());
  const auto begin = Clock::now();
  const MadeUpPlan plan{.trainees = bench.trainees, .attempts = bench.attempts};
  if (auto made = makeUpClass(*store, *curriculum, plan, kPassword, progress); !made)
    return tl::unexpected(made.error());
  bench.filled_s = secondsSince(begin);
  const auto seats = takeSeats(*store, *curriculum);
  if (!seats) return tl::unexpected(seats.error());
  Stopwatch watch(bench, progress, quick ? 20 : 100);
  if (auto done = askAll(*seats, watch); !done) return tl::unexpected(done.error());
  report(progress, "Asking", 1);
  bench.notes = {"A made-up class (`curriculum demo`) of " + std::to_string(bench.trainees) + " trainees with " +
                     std::to_string(bench.attempts) + " attempts each, in an SQLite file; " +
                     std::to_string(bench.trainees * bench.attempts) + " attempts in all.",
                 "Each query as the window asks it: by someone who is signed in, decided and, where it is about "
                 "others, written to "
                 "the audit log on the disk.",
                 "Of queries about one student, each round asks about the next."};
  return bench;
}

}  // namespace insonate::cli
