#include "ProbeLibrary.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <algorithm>

namespace insonate::train {
namespace {

/// Letters and digits of the name; others would be trouble in some file system.
QString fileNameFor(const QString& name) {
  QString plain;
  for (const QChar c : name.toLower()) plain += c.isLetterOrNumber() ? c : QChar('-');
  return plain;
}

}  // namespace

bool isBuiltIn(const std::string& name) {
  const std::vector<std::string> names = probePresetNames();
  return std::ranges::find(names, name) != names.end();
}

ProbeLibrary::ProbeLibrary(QString folder, QObject* parent) : QObject(parent), folder_(std::move(folder)) {
  if (folder_.isEmpty())
    folder_ = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/probes");
  read();
}

void ProbeLibrary::read() {
  entries_.clear();
  const QDir folder(folder_);
  for (const QString& file : folder.entryList({QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    const QString path = folder.filePath(file);
    if (auto probe = loadProbe(path.toStdString()))
      entries_.push_back({QString::fromStdString(probe->name), path, std::move(*probe)});
  }
  std::ranges::sort(entries_, [](const Entry& a, const Entry& b) { return a.name.localeAwareCompare(b.name) < 0; });
}

const ProbeLibrary::Entry* ProbeLibrary::find(const std::string& name) const {
  const auto found = std::ranges::find(entries_, QString::fromStdString(name), &Entry::name);
  return found == entries_.end() ? nullptr : &*found;
}

Result<void> ProbeLibrary::write(const Probe& probe, const QString& file) {
  if (!QDir().mkpath(folder_))
    return fail("The folder " + folder_.toStdString() + " could not be made; check that you may write there.");
  if (auto ok = saveProbe(probe, file.toStdString()); !ok) return ok;
  read();
  Q_EMIT changed();
  return {};
}

Result<void> ProbeLibrary::save(const Probe& probe) {
  if (isBuiltIn(probe.name))
    return fail("'" + probe.name + "' comes with the program and cannot be changed: give your probe another name.");
  if (const Entry* old = find(probe.name)) return write(probe, QString(old->file));
  const QString plain = fileNameFor(QString::fromStdString(probe.name));
  QString file = QDir(folder_).filePath(plain + QStringLiteral(".json"));
  for (int number = 2; QFile::exists(file); ++number)
    file = QDir(folder_).filePath(plain + QStringLiteral("-%1.json").arg(number));
  return write(probe, file);
}

Result<void> ProbeLibrary::rename(const std::string& name, const std::string& newName) {
  const Entry* entry = find(name);
  if (!entry) return fail("You have no probe named '" + name + "'.");
  if (isBuiltIn(newName) || find(newName)) return fail("There is a probe named '" + newName + "' already.");
  Probe probe = entry->probe;
  probe.name = newName;
  return write(probe, QString(entry->file));
}

Result<void> ProbeLibrary::remove(const std::string& name) {
  const Entry* entry = find(name);
  if (!entry) return fail("You have no probe named '" + name + "'.");
  if (!QFile::remove(entry->file)) return fail("Could not delete " + entry->file.toStdString() + ".");
  read();
  Q_EMIT changed();
  return {};
}

}  // namespace insonate::train
