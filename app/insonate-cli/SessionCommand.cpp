#include "AttemptImageFiles.h"
#include "AttemptReport.h"
#include "Commands.h"
#include "curriculum/RecordingCheck.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/simulator/AttemptImages.h>
#include <insonate/simulator/ScriptedSession.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

namespace insonate::cli {
namespace {

struct SessionArguments {
  std::string caseFolder, script, recording;
  AttemptImageOptions pictures;
  bool json = false;
};

struct ReplayArguments {
  std::string recording, caseFolder;
  AttemptImageOptions pictures;
  RecordingCheck check;
  double until_s = -1;
  bool metrics = false, json = false;
};

Result<PatientCase> caseOf(const std::string& folder) {
  auto read = readCase(folder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  replaceOwnLabels(read->patient);
  return std::move(read->patient);
}

/// Runs the script; `pictures` becomes what was written of them.
Result<SessionOutcome> runWithPictures(const SessionArguments& a, const SessionScript& script,
                                       const PatientCase& patient, nlohmann::json& pictures) {
  const auto run = [&](const TakeFrame& take) {
    return runSession(script, patient, "insonate " INSONATE_VERSION, a.recording, terminalProgress(),
                      {a.pictures.every_us(), take});
  };
  if (!a.pictures.wanted()) return run({});
  std::optional<Result<SessionOutcome>> done;
  auto list = writeAttemptPictures(a.pictures, [&](const TakeFrame& take) -> Result<void> {
    done.emplace(run(take));
    return *done ? Result<void>{} : tl::unexpected(done->error());
  });
  if (!list) return tl::unexpected(list.error());
  pictures = std::move(*list);
  return std::move(*done);
}

Result<nlohmann::json> picturesOf(const ReplayArguments& a, std::shared_ptr<const AttemptRecording> recording,
                                  std::int64_t until_us) {
  if (a.caseFolder.empty()) return fail("--images needs the case of the attempt: name its folder after the recording.");
  auto patient = caseOf(a.caseFolder);
  if (!patient) return tl::unexpected(patient.error());
  auto made = AttemptImages::make(std::move(recording), std::make_shared<const PatientCase>(std::move(*patient)));
  if (!made) return tl::unexpected(made.error());
  const Progress progress = terminalProgress();
  double last_s = -1;  // a frozen image is one
  return writeAttemptPictures(a.pictures, [&](const TakeFrame& take) -> Result<void> {
    for (std::int64_t time_us = a.pictures.every_us(); time_us <= until_us; time_us += a.pictures.every_us()) {
      if (!report(progress, "pictures", static_cast<double>(time_us) / static_cast<double>(until_us)))
        return fail(std::string(kCancelled));
      const auto frame = made->at(time_us);
      if (!frame) return tl::unexpected(frame.error());
      if (!*frame || std::exchange(last_s, (*frame)->time_s) == (*frame)->time_s) continue;
      if (auto ok = take(**frame); !ok) return ok;
    }
    return {};
  });
}

Result<void> runScript(const SessionArguments& a) {
  const auto patient = caseOf(a.caseFolder);
  if (!patient) return tl::unexpected(patient.error());
  const auto script = loadSessionScript(a.script, *patient);
  if (!script) return tl::unexpected(script.error());
  nlohmann::json pictures;
  const auto done = runWithPictures(a, *script, *patient, pictures);
  if (!done) return tl::unexpected(done.error());
  const AttemptScore score = computeScore(done->run, done->status);
  if (!a.json) {
    printAttempt(done->status, done->metrics, done->events, done->run.vessels());
    printScore(score);
    return {};
  }
  nlohmann::json object = attemptReport(done->status, done->metrics, done->events, done->run.vessels()),
                 findings = nlohmann::json::array();
  for (const ProcedureRun::Finding& finding : done->run.findings()) {
    const ProcedureRule& rule = done->run.procedure().rules[finding.rule];
    findings.push_back({{"t_s", static_cast<double>(finding.time_us) * 1e-6}, {"rule", rule.name}, {"say", rule.text}});
  }
  object.update(
      {{"succeeded", score.succeeded}, {"findings", findings}, {"score", scoreReport(score)}, {"record", a.recording}});
  if (a.pictures.wanted()) object["pictures"] = std::move(pictures);
  printJson(std::move(object));
  return {};
}

/// None where the procedure is not one of ours any more, which is said, or the recording is damaged, which was.
std::optional<AttemptScore> scoreUntil(const AttemptRecording& recording, std::int64_t until_us) {
  auto procedure = builtInProcedure(recording.header().procedure);
  if (!procedure) {
    std::cerr << "note: no score is computed: " << procedure.error().message << '\n';
    return std::nullopt;
  }
  ProcedureRun run(std::move(*procedure), recording.header().picture, recording.header().vessels);
  const auto played = recording.play(until_us, [&](const RecordingSegment::Entry& entry) {
    std::visit([&](const auto& what) { run.add(what); }, entry);
  });
  if (!played) return std::nullopt;
  return computeScore(run, recording.status());
}

/// With --attempt the case may be named alone: no recording is a folder.
ReplayArguments sorted(ReplayArguments a) {
  std::error_code ignored;
  if (!a.check.attempt.empty() && a.caseFolder.empty() && std::filesystem::is_directory(a.recording, ignored))
    a.caseFolder = std::exchange(a.recording, {});
  return a;
}

std::string nameOf(ProofState state) {
  switch (state) {
    case ProofState::Proven:
      return "proven";
    case ProofState::Demonstration:
      return "demonstration";
    case ProofState::Broken:
      return "changed";
    case ProofState::Unproven:
      break;
  }
  return "not proven";
}

Result<void> replay(const ReplayArguments& a) {
  const auto checked = a.check.check(a.recording);
  if (!checked) return tl::unexpected(checked.error());
  const RecordingProof& proof = checked->proof;
  auto opened = AttemptRecording::open(checked->file);
  if (!opened) return tl::unexpected(opened.error());
  const auto recording = std::make_shared<const AttemptRecording>(std::move(*opened));
  for (const std::string& error : recording->errors()) std::cerr << "note: " << error << '\n';
  const std::int64_t until_us = a.until_s < 0 ? recording->end_us() : static_cast<std::int64_t>(a.until_s * 1e6);
  const auto metrics = a.metrics ? recording->metricsUntil(until_us) : MetricValues{};
  if (!metrics) return tl::unexpected(metrics.error());
  std::vector<AttemptEvent> events;
  for (std::size_t i = 0; i < recording->segmentCount(); ++i) {
    const auto segment = recording->segment(i);
    if (!segment) return tl::unexpected(segment.error());
    for (const RecordingSegment::PlacedEvent& happened : segment->events)
      if (happened.event.time_us <= until_us) events.push_back(happened.event);
  }
  nlohmann::json pictures;
  if (a.pictures.wanted()) {
    auto list = picturesOf(a, recording, until_us);
    if (!list) return tl::unexpected(list.error());
    pictures = std::move(*list);
  }
  const auto score = a.metrics ? scoreUntil(*recording, until_us) : std::nullopt;
  if (!a.json) {
    printAttempt(recording->status(), *metrics, events, recording->header().vessels);
    std::printf("%s\n", (nameOf(proof.state) + (proof.why.empty() ? "." : ": " + proof.why)).c_str());
    if (score) printScore(*score);
    return {};
  }
  const AttemptHeader& header = recording->header();
  nlohmann::json object = attemptReport(recording->status(), *metrics, events, header.vessels);
  if (!a.metrics) object.erase("metrics");
  if (a.metrics) object["score"] = score ? scoreReport(*score) : nlohmann::json(nullptr);
  object.update({{"end_s", static_cast<double>(recording->end_us()) * 1e-6},
                 {"begun", header.begun},
                 {"procedure", header.procedure},
                 {"recorded_by", header.software},
                 {"case", header.caseName},
                 {"moved_by", {{"probe", header.hands.probe}, {"needle", header.hands.needle}}},
                 {"case_hash", header.caseHash},
                 {"proof", {{"state", nameOf(proof.state)}, {"why", proof.why}}},
                 {"troubles", recording->errors()}});
  if (a.pictures.wanted()) object["pictures"] = std::move(pictures);
  printJson(std::move(object));
  return {};
}

}  // namespace

void addSessionCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("session", "Play a whole attempt from a script, and record it");
  auto a = std::make_shared<SessionArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command
      ->add_option("--script", a->script,
                   "Script of the movements of the hands: name of a built-in script, or a JSON file")
      ->required()
      ->check(notEmpty());
  command->add_option("--record", a->recording, "New file for the recording")->required()->check(notEmpty());
  a->pictures.addTo(*command);
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = runScript(*a); !done) refuse(outcome, done.error());
  });
}

void addReplayCommand(CLI::App& app, Outcome& outcome) {
  auto* command =
      app.add_subcommand("replay", "Print events, metrics and score of a recorded attempt, and write its images");
  auto a = std::make_shared<ReplayArguments>();
  command->add_option("RECORDING", a->recording, "File of a recording (not needed with --attempt)")->check(notEmpty());
  command->add_option("CASE", a->caseFolder, "Folder of the attempt's case, which is needed for images")
      ->check(notEmpty());
  a->pictures.addTo(*command);
  a->check.addTo(*command);
  command->add_flag("--metrics", a->metrics, "Also compute metrics and score");
  command->add_option("--until", a->until_s, "Compute the values at this time of the attempt, s")
      ->check(CLI::NonNegativeNumber);
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    if (a->recording.empty() && a->check.attempt.empty()) throw CLI::RequiredError("RECORDING or --attempt");
    outcome.json = a->json;
    if (auto done = replay(sorted(*a)); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
