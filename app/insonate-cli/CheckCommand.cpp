#include "Commands.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/PatientCase.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace insonate::cli {
namespace {

struct CheckArguments {
  std::string folder;
  bool asJson = false;
};

nlohmann::json toJson(const std::vector<Finding>& findings) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Finding& f : findings) {
    nlohmann::json row{{"severity", nameOf(f.severity)}, {"code", f.code}, {"text", f.text}};
    if (f.place_mm) row["place_mm"] = {f.place_mm->x, f.place_mm->y, f.place_mm->z};
    if (f.label) row["label"] = f.label;
    rows.push_back(std::move(row));
  }
  return {{"fit", isFitForTraining(findings)}, {"findings", rows}};
}

nlohmann::json numberOrNull(const std::optional<double>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

nlohmann::json toJson(const DifficultyEstimate& e) {
  nlohmann::json shares = nlohmann::json::array();
  for (const DifficultyShare& share : e.shares)
    shares.push_back({{"what", share.what}, {"value", share.value}, {"points", share.points}});
  const VeinMeasures& m = e.measures;
  return {{"formula", DifficultyEstimate::kVersion},
          {"grade", e.grade},
          {"points", e.points},
          {"sentence", e.sentence},
          {"shares", shares},
          {"target", m.target},
          {"depth_mm", m.depth_mm},
          {"area_mm2", m.area_mm2},
          {"width_mm", m.width_mm},
          {"height_mm", m.height_mm},
          {"overlap_percent", numberOrNull(m.overlap_percent)},
          {"covered_percent", numberOrNull(m.covered_percent)},
          {"artery_angle_deg", numberOrNull(m.angle_deg)},
          {"artery_mm", numberOrNull(m.artery_mm)},
          {"second_artery_mm", numberOrNull(m.second_mm)},
          {"lung_mm", numberOrNull(m.lung_mm)}};
}

nlohmann::json difficultyJson(const PatientCase& patient, const Result<DifficultyEstimate>& estimate) {
  const std::string& given = patient.manifest.difficulty;
  nlohmann::json difficulty{{"author", given.empty() ? nlohmann::json() : nlohmann::json(given)}};
  if (estimate)
    difficulty["estimate"] = toJson(*estimate);
  else
    difficulty["reason"] = estimate.error().message;
  return difficulty;
}

void printDifficulty(const PatientCase& patient, const Result<DifficultyEstimate>& estimate) {
  if (!estimate) {
    std::printf("%s\n", estimate.error().message.c_str());
    return;
  }
  const VeinMeasures& m = estimate->measures;
  std::printf("Difficulty, estimated (formula %d): %s\n", DifficultyEstimate::kVersion, estimate->sentence.c_str());
  std::printf("  %s: %.1f mm deep, %.1f x %.1f mm, %.0f mm2", m.target.c_str(), m.depth_mm, m.width_mm, m.height_mm,
              m.area_mm2);
  if (m.artery_mm)
    std::printf("; artery %.1f mm away at %.0f degrees, %.0f %% of it behind the vein", *m.artery_mm, *m.angle_deg,
                *m.overlap_percent);
  std::printf("; %.2f points\n", estimate->points);
  if (!patient.manifest.difficulty.empty())
    std::printf("Difficulty, grade of the author: %s\n", patient.manifest.difficulty.c_str());
}

void print(const PatientCase& patient, const std::vector<Finding>& findings, bool asJson) {
  const auto estimate = estimateDifficulty(patient);
  if (asJson) {
    nlohmann::json answer = toJson(findings);
    answer["difficulty"] = difficultyJson(patient, estimate);
    return printJson(answer);
  }
  for (const Finding& f : findings)
    std::printf("%-7s  %-18s %s\n", std::string(nameOf(f.severity)).c_str(), f.code.c_str(), f.text.c_str());
  printDifficulty(patient, estimate);
  std::printf("%s\n",
              isFitForTraining(findings) ? "This case is fit for training." : "This case is not fit for training.");
}

Result<void> check(const CheckArguments& a) {
  const auto read = readCase(a.folder);
  if (!read) return tl::unexpected(read.error());
  auto findings = checkCase(read->patient, terminalProgress());
  if (!findings) return tl::unexpected(findings.error());
  for (const std::string& note : read->notes) findings->push_back({FindingSeverity::kInfo, "read_note", note});
  print(read->patient, *findings, a.asJson);
  return {};
}

}  // namespace

void addCheckCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand(
      "check", "Check whether a case is fit for training (the exit status is 1 only if the case cannot be read)");
  auto a = std::make_shared<CheckArguments>();
  command->add_option("CASE", a->folder, "Folder of the case")->required()->check(notEmpty());
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->asJson;
    if (auto done = check(*a); !done)
      refuse(outcome, done.error(), toJson({{FindingSeverity::kError, "unreadable", done.error().message}}));
  });
}

}  // namespace insonate::cli
