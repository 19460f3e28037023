#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/Judgement.h>

#include <QDateTime>
#include <cmath>
#include <optional>

namespace insonate {
namespace {

std::string yesNo(std::optional<bool> value) {
  if (!value) return {};
  return *value ? "yes" : "no";
}

std::string nameOf(AttemptState state) {
  switch (state) {
    case AttemptState::Open:
      return "open";
    case AttemptState::Completed:
      return "completed";
    case AttemptState::Abandoned:
      return "abandoned";
    case AttemptState::Voided:
      break;
  }
  return "voided";
}

std::string isoOf(std::int64_t time_us) {
  return QDateTime::fromMSecsSinceEpoch(time_us / 1000, Qt::UTC).toString(Qt::ISODateWithMs).toStdString();
}

}  // namespace

std::string numberOf(double value) {
  const double size = std::abs(value);
  const int digits = size >= 100 || value == std::round(value) ? 0 : size >= 10 ? 1 : 2;
  return QString::number(value, 'f', digits).toStdString();
}

const char* nameOf(AttemptProof proof) {
  switch (proof) {
    case AttemptProof::Verifying:
      return "being verified";
    case AttemptProof::Proven:
      return "proven";
    case AttemptProof::Accepted:
      return "accepted";
    case AttemptProof::Earlier:
      return "earlier";
    case AttemptProof::Demonstration:
      return "demonstration";
    case AttemptProof::Unproven:
      break;
  }
  return "not proven";
}

const char* nameOf(TestConditions testConditions) {
  switch (testConditions) {
    case TestConditions::Earlier:
      return "earlier";
    case TestConditions::Opened:
      return "opened";
    case TestConditions::SelfAdministered:
      return "self-administered";
    case TestConditions::None:
    case TestConditions::Practice:
      return "practice";
    case TestConditions::Undecided:
      break;
  }
  return "undecided";
}

std::vector<std::string> attemptColumns() {
  return {"id",     "begun (UTC)",     "curriculum", "version",     "level",  "procedure",
          "case",   "assistance",      "state",      "broke off",   "voided", "succeeded",
          "passed", "critical errors", "points",     "duration, s", "proof",  "sitting"};
}

std::vector<std::string> attemptRow(const AttemptFacts& attempt, const Curriculum* curriculum) {
  const Level* level = curriculum ? levelOf(*curriculum, attempt) : nullptr;
  return {attempt.id,
          isoOf(attempt.begun_us),
          attempt.curriculum,
          attempt.curriculum.empty() ? "" : std::to_string(attempt.curriculumVersion),
          attempt.level,
          attempt.procedure,
          attempt.caseName,
          level ? std::string(nameOf(level->assistance)) : "",
          nameOf(attempt.state),
          yesNo(hasBrokenOff(attempt)),
          yesNo(attempt.state == AttemptState::Voided),
          yesNo(isSuccess(attempt)),
          yesNo(curriculum ? passedIn(*curriculum, attempt) : std::nullopt),
          std::to_string(attempt.criticalErrors),
          csvNumber(pointsOf(attempt)),
          csvNumber(static_cast<double>(attempt.length_us) * 1e-6),
          nameOf(attempt.proof),
          level && level->assistance == Assistance::Test ? nameOf(attempt.testConditions) : ""};
}

}  // namespace insonate
