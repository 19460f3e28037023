#include "Commands.h"

#include <insonate/core/Fingerprint.h>
#include <insonate/preparation/CaseReport.h>
#include <insonate/preparation/StudyPreparation.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The part of the studies that one of several jobs prepares: `index` from 1 to `count`.
struct Shard {
  std::uint64_t index = 1, count = 1;
  bool has(const std::string& id) const { return std::stoull(id, nullptr, 16) % count == index - 1; }
};

struct PrepareArguments {
  std::vector<std::string> folders;
  std::string library, shard = "1/1";
  bool asJson = false;
};

Result<Shard> readShard(const std::string& text) {
  Shard shard;
  const char *end = text.data() + text.size(), *at = text.data();
  const auto index = std::from_chars(at, end, shard.index);
  const bool hasSlash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = hasSlash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!hasSlash || count.ec != std::errc() || count.ptr != end || shard.index < 1 || shard.index > shard.count)
    return fail("--shard needs I/N with I from 1 to N, for example 2/8; got \"" + text + "\".");
  return shard;
}

struct Totals {
  int prepared = 0, skipped = 0, failed = 0, others = 0;
};

/// Prepares the studies of this shard one after the other.
class Preparation {
 public:
  Preparation(const fs::path& library, const Shard& shard) : library_(library), shard_(shard) {}

  /// Fails only if nothing more can be done: canceled, or the library cannot be written.
  Result<void> prepare(const std::string& folder) {
    auto study = findStudy(folder, terminalProgress());
    if (!study && study.error().message == kCancelled) return tl::unexpected(study.error());
    Fingerprint path;
    path.add(fs::absolute(folder).lexically_normal().string());
    const std::string id = study ? study->id : path.text();
    if (!shard_.has(id)) return ++totals_.others, Result<void>();
    if (!study) return reportFailure(folder, id, study.error().message);
    if (isReportOfCase(reportOf(id)) && fs::exists(caseOf(id) / "case.json")) {
      ++totals_.skipped;
      std::cerr << folder << ": prepared before as " << caseOf(id).string() << '\n';
      return {};
    }
    auto prepared = prepareStudy(*study, terminalProgress());
    if (!prepared && prepared.error().message == kCancelled) return tl::unexpected(prepared.error());
    if (!prepared) return reportFailure(folder, id, prepared.error().message);
    if (auto ok = writeCase(prepared->patient, caseOf(id), terminalProgress()); !ok) return ok;
    if (auto ok = writeCaseReport(*prepared, id, reportOf(id), terminalProgress()); !ok) return ok;
    ++totals_.prepared;
    std::cerr << folder << ": " << caseOf(id).string() << '\n';
    return {};
  }
  const Totals& totals() const { return totals_; }
  fs::path reports() const { return library_ / "report"; }

 private:
  fs::path caseOf(const std::string& id) const { return library_ / ("case-" + id); }
  fs::path reportOf(const std::string& id) const { return reports() / id; }

  Result<void> reportFailure(const std::string& folder, const std::string& id, const std::string& reason) {
    ++totals_.failed;
    std::cerr << folder << ": " << reason << '\n';
    // The page is for everyone who may read the library; the folder's name may be a patient's.
    std::string withoutFolder = reason;
    for (auto at = withoutFolder.find(folder); at != std::string::npos; at = withoutFolder.find(folder, at))
      withoutFolder.replace(at, folder.size(), "The study's folder");
    return writeFailureReport(id, withoutFolder, reportOf(id));
  }

  fs::path library_;
  Shard shard_;
  Totals totals_;
};

Result<void> prepareAll(const PrepareArguments& a, Outcome& outcome) {
  const auto shard = readShard(a.shard);
  if (!shard) return tl::unexpected(shard.error());
  Preparation work(a.library, *shard);
  std::error_code failure;
  fs::create_directories(work.reports(), failure);
  if (failure)
    return fail("The folder " + work.reports().string() + " cannot be made (" + failure.message() +
                "). Choose a folder in which you may write.");
  for (const std::string& folder : a.folders)
    if (auto ok = work.prepare(folder); !ok) return ok;
  if (auto ok = updateReportPage(work.reports()); !ok) return ok;
  const Totals& n = work.totals();
  std::fprintf(stderr, "%d prepared, %d prepared before, %d failed, %d in other shards. Report: %s\n", n.prepared,
               n.skipped, n.failed, n.others, (work.reports() / "index.html").c_str());
  if (a.asJson)
    printJson({{"prepared", n.prepared},
               {"prepared_before", n.skipped},
               {"failed", n.failed},
               {"in_other_shards", n.others},
               {"report", (work.reports() / "index.html").string()}});
  if (n.failed > 0) outcome.status = 1;
  return {};
}

}  // namespace

void addPrepareCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("prepare", "Prepare cases from many studies, for an author to confirm");
  auto a = std::make_shared<PrepareArguments>();
  command->add_option("FOLDER", a->folders, "Folders, each with one study (DICOM), or volume files")
      ->required()
      ->check(notEmpty());
  command->add_option("--out", a->library, "Folder of the cases; the report is written to its subfolder report")
      ->required()
      ->check(notEmpty());
  command->add_option("--shard", a->shard,
                      "Prepare only part I of N of the studies, so that N jobs can share the work, for example 2/8");
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->footer(
      "A study that was prepared before is skipped, so that an interrupted command can be repeated. A study that "
      "cannot "
      "be prepared does not stop the others; the exit status is then 1.");
  command->callback([a, &outcome] {
    outcome.json = a->asJson;
    if (const auto done = prepareAll(*a, outcome); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
