#include "UnsentFacts.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QJsonValue>
#include <QUuid>
#include <algorithm>
#include <optional>
#include <tuple>

namespace insonate::train {
namespace {

constexpr qint64 kMost_bytes = 1 << 20;

QJsonValue json(const std::string& text) {
  return QString::fromStdString(text);
}

QJsonValue json(const std::optional<double>& value) {
  return value ? QJsonValue(*value) : QJsonValue();
}

std::string text(const QJsonObject& object, const char* key) {
  return object[QLatin1String(key)].toString().toStdString();
}

std::optional<double> number(const QJsonValue& value) {
  return value.isDouble() ? std::optional(value.toDouble()) : std::nullopt;
}

/// Times in microseconds since 1970 stay whole in a double until the year 2255.
QJsonObject objectOf(const AttemptFacts& facts) {
  QJsonArray metrics;
  for (const MetricFact& one : facts.metrics)
    metrics << QJsonObject{{"id", json(one.id)}, {"version", one.version}, {"value", json(one.value)}};
  return {{"id", json(facts.id)},
          {"person", json(facts.person)},
          {"curriculum", json(facts.curriculum)},
          {"curriculumVersion", facts.curriculumVersion},
          {"level", json(facts.level)},
          {"procedure", json(facts.procedure)},
          {"procedureVersion", facts.procedureVersion},
          {"caseName", json(facts.caseName)},
          {"caseHash", json(facts.caseHash)},
          {"begun_us", double(facts.begun_us)},
          {"length_us", double(facts.length_us)},
          {"state", int(facts.state)},
          {"succeeded", facts.succeeded},
          {"criticalErrors", facts.criticalErrors},
          {"points", json(facts.points)},
          {"metrics", metrics},
          {"recording", json(facts.recording)},
          {"recordingHash", json(facts.recordingHash)},
          {"handsHash", json(facts.handsHash)}};
}

std::optional<AttemptFacts> factsOf(const QJsonObject& object) {
  AttemptFacts facts;
  facts.id = text(object, "id"), facts.person = text(object, "person");
  facts.curriculum = text(object, "curriculum"), facts.level = text(object, "level");
  facts.curriculumVersion = object["curriculumVersion"].toInt();
  facts.procedure = text(object, "procedure"), facts.procedureVersion = object["procedureVersion"].toInt();
  facts.caseName = text(object, "caseName"), facts.caseHash = text(object, "caseHash");
  facts.begun_us = std::int64_t(object["begun_us"].toDouble());
  facts.length_us = std::int64_t(object["length_us"].toDouble());
  const int state = object["state"].toInt(-1);
  if (state < int(AttemptState::Open) || state > int(AttemptState::Abandoned) || facts.id.empty()) return std::nullopt;
  facts.state = AttemptState(state);
  facts.succeeded = object["succeeded"].toBool();
  facts.criticalErrors = object["criticalErrors"].toInt();
  facts.points = number(object["points"]);
  for (const QJsonValue& one : object["metrics"].toArray()) {
    const QJsonObject metric = one.toObject();
    facts.metrics.push_back({text(metric, "id"), metric["version"].toInt(), number(metric["value"])});
  }
  facts.recording = text(object, "recording"), facts.recordingHash = text(object, "recordingHash");
  facts.handsHash = text(object, "handsHash");
  return facts;
}

/// A begun attempt and its end have a file each, so that who forgets the one that the store took, or writes it late,
/// does not touch the other.
QString fileOf(const QString& folder, const AttemptFacts& facts, AttemptState state) {
  return QDir(folder).filePath(QUuid(QString::fromStdString(facts.id)).toString(QUuid::WithoutBraces) +
                               (state == AttemptState::Open ? QStringLiteral(".begun.json") : QStringLiteral(".json")));
}

}  // namespace

QString unsentFolder() {
  return ui::attemptsFolder() + QStringLiteral("/unsent");
}

Result<void> keepUnsent(const QString& folder, const AttemptFacts& facts) {
  if (!QDir().mkpath(folder))
    return fail("The folder " + folder.toStdString() + " cannot be made; check that you may write there.");
  const QByteArray bytes = QJsonDocument(objectOf(facts)).toJson();
  const auto written = writeAtomically(fileOf(folder, facts, facts.state).toStdString(),
                                       std::string_view(bytes.constData(), bytes.size()));
  if (written && facts.state != AttemptState::Open) QFile::remove(fileOf(folder, facts, AttemptState::Open));
  return written;
}

std::vector<AttemptFacts> unsentOf(const QString& folder, const std::string& person) {
  std::vector<AttemptFacts> all;
  const QDir place(folder);
  for (const QString& name : place.entryList({QStringLiteral("*.json")}, QDir::Files)) {
    QFile file(place.filePath(name));
    if (file.size() > kMost_bytes || !file.open(QIODevice::ReadOnly)) continue;
    auto facts = factsOf(QJsonDocument::fromJson(file.readAll()).object());
    if (facts && facts->person == person) all.push_back(std::move(*facts));
  }
  std::ranges::sort(all, {}, [](const AttemptFacts& f) { return std::tuple(f.begun_us, f.id, f.state); });
  return all;
}

void forgetUnsent(const QString& folder, const AttemptFacts& facts) {
  QFile::remove(fileOf(folder, facts, facts.state));
}

}  // namespace insonate::train
