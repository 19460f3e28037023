#include "AttemptReport.h"
#include "Commands.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ScriptedSession.h>

#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <optional>
#include <variant>

namespace insonate::cli {
namespace {

struct SessionArguments {
  std::string caseFolder, script, recording;
  bool json = false;
};

struct ReplayArguments {
  std::string recording;
  double until_s = -1;
  bool metrics = false, json = false;
};

Result<void> runScript(const SessionArguments& a) {
  const auto read = readCase(a.caseFolder);
  if (!read) return tl::unexpected(read.error());
  for (const std::string& note : read->notes) std::cerr << "note: " << note << '\n';
  std::ifstream file(a.script, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file) return fail("The script " + a.script + " cannot be read; check its name and permissions.");
  const auto script = readSessionScript(text, read->patient);
  if (!script) return fail(a.script + ": " + script.error().message);
  const auto done = runSession(*script, read->patient, "insonate " INSONATE_VERSION, a.recording, terminalProgress());
  if (!done) return tl::unexpected(done.error());
  const AttemptScore score = scoreOf(done->run);
  if (!a.json) {
    printAttempt(done->status, done->metrics, done->events);
    printScore(score);
    return {};
  }
  nlohmann::json object = attemptReport(done->status, done->metrics, done->events), findings = nlohmann::json::array();
  for (const ProcedureRun::Finding& finding : done->run.findings()) {
    const ProcedureRule& rule = done->run.procedure().rules[finding.rule];
    findings.push_back({{"t_s", static_cast<double>(finding.time_us) * 1e-6}, {"rule", rule.name}, {"say", rule.say}});
  }
  object.update(
      {{"succeeded", score.succeeded}, {"findings", findings}, {"score", scoreReport(score)}, {"record", a.recording}});
  printJson(std::move(object));
  return {};
}

/// None where the procedure is not one of ours any more, which is said, or the recording is damaged, which was.
std::optional<AttemptScore> scoreUntil(const AttemptRecording& recording, std::int64_t until_us) {
  auto procedure = loadProcedure(recording.header().procedure);
  if (!procedure) {
    std::cerr << "note: no score is computed: " << procedure.error().message << '\n';
    return std::nullopt;
  }
  ProcedureRun run(std::move(*procedure), recording.header().picture);
  const auto played = recording.play(until_us, [&](const AttemptRecording::Entry& entry) {
    std::visit([&](const auto& what) { run.take(what); }, entry);
  });
  if (!played) return std::nullopt;
  return scoreOf(run);
}

Result<void> replay(const ReplayArguments& a) {
  const auto recording = AttemptRecording::open(a.recording);
  if (!recording) return tl::unexpected(recording.error());
  for (const std::string& trouble : recording->troubles()) std::cerr << "note: " << trouble << '\n';
  const std::int64_t until_us = a.until_s < 0 ? recording->end_us() : static_cast<std::int64_t>(a.until_s * 1e6);
  const auto metrics = a.metrics ? recording->metricsUntil(until_us) : MetricValues{};
  if (!metrics) return tl::unexpected(metrics.error());
  std::vector<AttemptEvent> events;
  for (std::size_t i = 0; i < recording->stretches(); ++i) {
    const auto stretch = recording->stretch(i);
    if (!stretch) return tl::unexpected(stretch.error());
    for (const Stretch::Happened& happened : stretch->events)
      if (happened.event.time_us <= until_us) events.push_back(happened.event);
  }
  const auto score = a.metrics ? scoreUntil(*recording, until_us) : std::nullopt;
  if (!a.json) {
    printAttempt(recording->status(), *metrics, events);
    if (score) printScore(*score);
    return {};
  }
  const AttemptHeader& header = recording->header();
  nlohmann::json object = attemptReport(recording->status(), *metrics, events);
  if (!a.metrics) object.erase("metrics");
  if (a.metrics) object["score"] = score ? scoreReport(*score) : nlohmann::json(nullptr);
  object.update({{"end_s", static_cast<double>(recording->end_us()) * 1e-6},
                 {"begun", header.begun},
                 {"procedure", header.procedure},
                 {"recorded_by", header.software},
                 {"case", header.caseName},
                 {"case_hash", header.caseHash},
                 {"troubles", recording->troubles()}});
  printJson(std::move(object));
  return {};
}

}  // namespace

void addSessionCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("session", "A whole attempt from a script, recorded; tissue at rest, no pictures");
  auto a = std::make_shared<SessionArguments>();
  command->add_option("CASE", a->caseFolder, "Folder of the case")->required()->check(notEmpty());
  command->add_option("--script", a->script, "What the hands do (JSON)")->required()->check(notEmpty());
  command->add_option("--record", a->recording, "New file for the recording")->required()->check(notEmpty());
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = runScript(*a); !done) refuse(outcome, done.error());
  });
}

void addReplayCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand("replay", "Events and metrics of a recorded attempt");
  auto a = std::make_shared<ReplayArguments>();
  command->add_option("RECORDING", a->recording, "File of session --record")->required()->check(notEmpty());
  command->add_flag("--metrics", a->metrics, "Metrics and score, too, computed anew");
  command->add_option("--until", a->until_s, "As they stood at this time (s)")->check(CLI::NonNegativeNumber);
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = replay(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
