#include "CurriculumBench.h"

#include "LevelPath.h"
#include "MetricSeries.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/Statistics.h>
#include <insonate/teaching/DemoClass.h>

#include <QTemporaryDir>
#include <algorithm>
#include <chrono>

namespace insonate::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kPassword = "made up for a benchmark";

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

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
    return ask(screen, query, asked, rounds_);
  }
  /// Queries that are slow but made once.
  Result<void> ask(const char* screen, const char* query, const Query& asked, int rounds) {
    CurriculumBenchRow row{.screen = screen, .query = query, .rows = 0, .asked = rounds};
    std::vector<double> times_ms;
    for (int round = 0; round < rounds; ++round) {
      if (!report(progress_, query, static_cast<double>(round) / rounds)) return fail(std::string(kCancelled));
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
  Cohort cohort, half;
  std::vector<std::string> trainees;  ///< Person::id
  Curriculum curriculum;
  Form checklist;
};

Result<Seats> takeSeats(const CurriculumStore& store, const Curriculum& curriculum) {
  const auto teacher = store.signIn(kDemoInstructor, kPassword), trainee = store.signIn("made-up-001", kPassword),
             administrator = store.signIn(kDemoAdministrator, kPassword);
  for (const auto* by : {&teacher, &trainee, &administrator})
    if (!*by) return tl::unexpected(by->error());
  const auto cohorts = CohortStore(*teacher).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  const auto cohort = std::ranges::find(*cohorts, kDemoClass, &Cohort::name),
             half = std::ranges::find(*cohorts, kDemoHalfClass, &Cohort::name);
  const auto checklist = loadForm("jugular_checklist");
  if (!checklist) return tl::unexpected(checklist.error());
  const auto members = CohortStore(*teacher).members(cohort->id);
  if (!members) return tl::unexpected(members.error());
  Seats seats{*teacher, *trainee, *administrator, *cohort, *half, {}, curriculum, *checklist};
  for (const Member& member : *members)
    if (!member.teaches) seats.trainees.push_back(member.person.id);
  return seats;
}

/// Two judge the newest attempt of each.
Result<void> judgeAll(const Seats& seats) {
  FormAnswers answers;
  for (const FormSection& section : seats.checklist.sections)
    for (const FormItem& item : section.items)
      if (item.kind == FormItem::Kind::Choice) answers[item.name] = item.options.front().name;
  for (const std::string& person : seats.trainees) {
    const auto newest = AttemptStore(seats.teacher).page(person, 1);
    if (!newest) return tl::unexpected(newest.error());
    for (const SignedIn* rater : {&seats.teacher, &seats.administrator}) {
      const auto kept = FormStore(*rater).add({.form = seats.checklist.name,
                                               .formVersion = seats.checklist.version,
                                               .person = person,
                                               .attempt = newest->front().facts.id,
                                               .answers = answersText(answers)});
      if (!kept) return tl::unexpected(kept.error());
    }
  }
  return {};
}

/// A class list with all who learn, and as many who are new.
ClassList classListOf(const Seats& seats) {
  ClassList list;
  for (std::size_t i = 0; i < 2 * seats.trainees.size(); ++i) {
    const std::string name = "made-up-" + std::to_string(1000 + i).substr(1);
    list.entries.push_back(
        {.line = static_cast<int>(i) + 2, .person = {.name = name, .fullName = "Made up", .email = ""}});
  }
  return list;
}

Result<void> askAll(const Seats& seats, Stopwatch& watch) {
  const SignedIn &teacher = seats.teacher, &trainee = seats.trainee, &administrator = seats.administrator;
  const Cohort &cohort = seats.cohort, &half = seats.half;
  const auto& trainees = seats.trainees;
  const Curriculum& curriculum = seats.curriculum;
  const Form& checklist = seats.checklist;
  const auto someone = [&](int round) { return trainees[static_cast<std::size_t>(round) % trainees.size()]; };
  const ClassList list = classListOf(seats);
  const Query levels = [&](int) { return sizeOf(CohortStore(teacher).standings(cohort.id, trainees)); };
  if (auto done = watch.ask("class overview", "levels of all, the first time by another curriculum", levels, 1); !done)
    return done;
  const std::pair<std::pair<const char*, const char*>, Query> asked[]{
      {{"class overview", "levels of all"}, levels},
      {{"class overview", "people of a class with level and last attempt"},
       [&](int) { return sizeOf(CohortStore(teacher).members(cohort.id)); }},
      {{"class overview", "the last 10 attempts of each, for the heat map"},
       [&](int) { return sizeOf(AttemptStore(teacher).recentOfCohort(cohort.id, 10)); }},
      {{"student", "all attempts, for curves"},
       [&](int i) { return sizeOf(AttemptStore(teacher).history(someone(i))); }},
      {{"student", "a page of attempts, newest first"},
       [&](int i) { return sizeOf(AttemptStore(teacher).page(someone(i), 50)); }},
      {{"student", "all attempts and the path worked out from them"},
       [&](int i) { return sizeOf(levelPath(teacher, curriculum, someone(i))); }},
      {{"student", "forms"}, [&](int i) { return sizeOf(FormStore(teacher).listByPerson(someone(i))); }},
      {{"comparison", "two classes, the last 10 attempts of each"},
       [&](int i) { return sizeOf(AttemptStore(teacher).recentOfCohort(i % 2 ? cohort.id : half.id, 10)); }},
      {{"raters", "forms of a class"},
       [&](int) { return sizeOf(FormStore(teacher).listByCohort(cohort.id, checklist.name)); }},
      {{"raters", "how far two raters agree"},
       [&](int) -> Result<std::size_t> {
         const auto agreement = FormStore(teacher).agreement(cohort.id, checklist);
         return agreement ? Result<std::size_t>(agreement->judgedTwice) : tl::unexpected(agreement.error());
       }},
      {{"replay", "whose attempt a recording is"},
       [&](int) -> Result<std::size_t> {
         const auto id = AttemptStore(teacher).findByRecording("nobody's.attempt", std::string(64, 'f'));
         return id ? Result<std::size_t>(id->size()) : tl::unexpected(id.error());
       }},
      {{"trainee", "own path of levels"},
       [&](int) { return sizeOf(levelPath(trainee, curriculum, trainee.person().id)); }},
      {{"trainee", "own attempts, newest first"},
       [&](int) { return sizeOf(AttemptStore(trainee).page(trainee.person().id, 50)); }},
      {{"curriculum", "published curricula"}, [&](int) { return sizeOf(PublishedCurricula(teacher).list()); }},
      {{"class list", "what a list of all would change"},
       [&](int) { return sizeOf(ClassImport(administrator).plan(cohort.id, list)); }},
      {{"upload", "what waits for the server"}, [&](int) { return sizeOf(pendingUploads(teacher, 1000)); }},
      {{"people", "everyone"}, [&](int) { return sizeOf(PeopleStore(administrator).all()); }},
      {{"people", "classes"}, [&](int) { return sizeOf(CohortStore(administrator).cohorts()); }},
      {{"audit log", "a page of the log"}, [&](int) { return sizeOf(AuditLog(administrator).page(100)); }},
      {{"audit log", "a page about one person"},
       [&](int i) { return sizeOf(AuditLog(administrator).page(100, 0, someone(i))); }}};
  for (const auto& [name, query] : asked)
    if (auto done = watch.ask(name.first, name.second, query); !done) return done;
  return {};
}

}  // namespace

Result<CurriculumBench> runCurriculumBench(bool quick, const Progress& progress) {
  const QTemporaryDir folder;
  if (!folder.isValid()) return fail("The folder for temporary files cannot be written; name another in TMPDIR.");
  CurriculumBench bench{.trainees = quick ? 20 : 200, .attempts = quick ? 50 : 500, .rows = {}, .notes = {}};
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  StoreServices services;
  services.passwordCost = PasswordCost::Minimum;
  const auto store = CurriculumStore::open(folder.filePath(QStringLiteral("made-up.sqlite")).toStdString(), services);
  if (!store) return tl::unexpected(store.error());
  const auto begin = Clock::now();
  const DemoClassPlan plan{.trainees = bench.trainees, .attempts = bench.attempts};
  if (auto made = makeDemoClass(*store, *curriculum, plan, kPassword, progress); !made)
    return tl::unexpected(made.error());
  bench.filled_s = secondsSince(begin);
  const auto seats = takeSeats(*store, *curriculum);
  if (!seats) return tl::unexpected(seats.error());
  if (auto judged = judgeAll(*seats); !judged) return tl::unexpected(judged.error());
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
