#include "UnsentFacts.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/ui/Attempts.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
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

std::string text(const QJsonObject& object, const char* key) {
  return object[QLatin1String(key)].toString().toStdString();
}

/// Times in microseconds since 1970 stay whole in a double until the year 2255.
QJsonObject objectOf(const AttemptFacts& facts) {
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
          {"state", int(facts.state)},
          {"recording", json(facts.recording)}};
}

/// Facts in the file; earlier programs wrote the end into it, too.
std::optional<AttemptFacts> factsOf(const QJsonObject& object) {
  AttemptFacts facts;
  facts.id = text(object, "id"), facts.person = text(object, "person");
  facts.curriculum = text(object, "curriculum"), facts.level = text(object, "level");
  facts.curriculumVersion = object["curriculumVersion"].toInt();
  facts.procedure = text(object, "procedure"), facts.procedureVersion = object["procedureVersion"].toInt();
  facts.caseName = text(object, "caseName"), facts.caseHash = text(object, "caseHash");
  facts.begun_us = std::int64_t(object["begun_us"].toDouble());
  const int state = object["state"].toInt(-1);
  if (state < int(AttemptState::Open) || state > int(AttemptState::Abandoned) || facts.id.empty()) return std::nullopt;
  facts.state = AttemptState(state);
  facts.recording = text(object, "recording");
  return facts;
}

/// With the end, if there is one; none where it cannot be told yet.
std::optional<AttemptFacts> withEnd(AttemptFacts facts, const QString& folder) {
  if (facts.state == AttemptState::Open) return facts;
  const QString recording = recordingOf(folder, facts);
  if (!QFileInfo(recording).isFile()) {
    facts.state = AttemptState::Abandoned;
    facts.recording.clear();
    return facts;
  }
  return takeRecording(facts, recording.toStdString()) ? std::optional(std::move(facts)) : std::nullopt;
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

QString recordingOf(const QString& folder, const AttemptFacts& facts) {
  const QString name = QString::fromStdString(facts.recording);
  // A name is never a way out of the folder.
  if (name.isEmpty() || name == QLatin1String(".") || name == QLatin1String("..") || QFileInfo(name).fileName() != name)
    return {};
  return QDir(QFileInfo(folder).path()).filePath(name);
}

Result<void> storeUnsent(const QString& folder, const AttemptFacts& facts) {
  if (!QDir().mkpath(folder))
    return fail("The folder " + folder.toStdString() + " cannot be made; check that you may write there.");
  const QByteArray bytes = QJsonDocument(objectOf(facts)).toJson();
  auto written = writeAtomically(fileOf(folder, facts, facts.state).toStdString(),
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
    if (!facts || facts->person != person) continue;
    if (auto ended = withEnd(std::move(*facts), folder)) all.push_back(std::move(*ended));
  }
  std::ranges::sort(all, {}, [](const AttemptFacts& f) { return std::tuple(f.begun_us, f.id, f.state); });
  return all;
}

void recoverInterrupted(const QString& folder, const std::string& person) {
  const QDir recordings(QFileInfo(folder).path());
  const QString partial = QString::fromStdString(AttemptRecorder::partialFile("*").string());
  for (const QString& name : recordings.entryList({partial}, QDir::Files)) {
    const std::filesystem::path path = recordings.filePath(name).toStdString();
    const auto recording = AttemptRecording::open(path);
    if (!recording || recording->header().recordedFor.person != person) continue;
    const auto file = AttemptRecorder::recover(path);
    if (!file) continue;
    AttemptFacts facts = factsFromHeader(recording->header());
    facts.state = AttemptState::Abandoned;
    facts.recording = file->filename().string();
    (void)storeUnsent(folder, facts);
  }
}

void forgetUnsent(const QString& folder, const AttemptFacts& facts) {
  QFile::remove(fileOf(folder, facts, facts.state));
}

}  // namespace insonate::train
