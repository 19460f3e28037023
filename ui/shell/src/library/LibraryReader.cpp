#include "LibraryReader.h"

#include "BuiltInCase.h"
#include "SlicePreview.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseStatistics.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/tissue/Labels.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/Text.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QStandardPaths>
#include <algorithm>

namespace insonate::ui {
namespace {

constexpr int kThumbnail_px = 160;
/// Version of the cache's format; increase it when the stored facts change, or the check from which they come.
constexpr int kFormat = 3;

QImage ultrasoundOf(const CaseView& patient) {
  const auto start = autoStartPose(patient);
  const auto probe = loadProbe("linear");
  const auto tissues = loadAcousticTable(acousticPresetNames().front());
  if (!start || !probe || !tissues) return {};
  const auto pose = patientFromProbe(start->position_mm, start->axial, start->lateral);
  if (!pose) return {};
  ImagingSetup setup;
  setup.probe = *probe;
  setup.settings = settingsFor(setup.probe);
  setup.settings.scanlines = 128, setup.settings.samples = 320;
  setup.settings.width = 240, setup.settings.height = 240;
  setup.tissues = *tissues;
  setup.engine = "cpu";
  const auto scene = makeScene(patient, setup, sceneRegion(setup, *pose));
  auto imager = Imager::make(setup);
  if (!scene || !imager) return {};
  ImagingFrame frame;
  imager->render(**scene, *pose, frame);
  const BModeImage& image = frame.image;
  const QImage whole(image.gray.data(), image.width, image.height, image.width, QImage::Format_Grayscale8);
  return whole.scaled(kThumbnail_px, kThumbnail_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
}

void findOut(const PatientCase& patient, LibraryEntry& entry, const Progress& progress) {
  const auto findings = checkCase(patient, progress);
  const auto statistics = caseStatistics(patient, progress);
  if (!findings || !statistics) return;
  for (const Finding& finding : *findings) {
    if (finding.severity == FindingSeverity::kError) entry.errors << QString::fromStdString(finding.text);
    if (finding.severity == FindingSeverity::kWarning) entry.warnings << QString::fromStdString(finding.text);
  }
  entry.fit = isFitForTraining(*findings);
  for (int label = 1; label < 256; ++label)
    if (statistics->voxels[std::size_t(label)] > 0)
      entry.structures << QString::fromStdString(labelName(patient.manifest.ownLabels, std::uint8_t(label)));
  const auto estimate = estimateDifficulty(patient);
  entry.graded = !patient.manifest.difficulty.empty();
  entry.grade = QString::fromStdString(gradeOf(patient));
  entry.reason = QString::fromStdString(estimate ? estimate->sentence : estimate.error().message);
  entry.slice = slicePreview(patient.ct, kThumbnail_px);
  const auto tissues = withTissueLabels(patient.manifest.ownLabels, patient.labels);
  entry.ultrasound = ultrasoundOf(tissues ? CaseView(patient, *tissues) : CaseView(patient));
  entry.state = LibraryEntry::State::Known;
}

/// Empty for a neck that is not on disk, since its facts cannot be identified.
QString keptFile(const QString& cache, const LibraryEntry& entry, const QString& folder) {
  if (!QFileInfo::exists(folder)) return {};
  const std::string state = diskFingerprint(folder.toStdString());
  return QDir(cache).filePath(
      QStringLiteral("%1%2-%3").arg(entry.builtIn ? QStringLiteral("b") : QString(), QString::fromStdString(state),
                                    QString::number(kFormat * 100 + DifficultyEstimate::kVersion)));
}

void keep(const LibraryEntry& entry, const QString& file) {
  if (file.isEmpty()) return;
  const QJsonObject object{{"grade", entry.grade},
                           {"graded", entry.graded},
                           {"reason", entry.reason},
                           {"structures", QJsonArray::fromStringList(entry.structures)},
                           {"fit", entry.fit},
                           {"errors", QJsonArray::fromStringList(entry.errors)},
                           {"warnings", QJsonArray::fromStringList(entry.warnings)}};
  QDir().mkpath(QFileInfo(file).path());
  entry.slice.save(file + QStringLiteral("-ct.png"));
  entry.ultrasound.save(file + QStringLiteral("-us.png"));
  // Written last, so that an existing file is complete.
  QSaveFile out(file + QStringLiteral(".json"));
  if (out.open(QIODevice::WriteOnly) && out.write(QJsonDocument(object).toJson()) > 0) out.commit();
}

bool takeKept(LibraryEntry& entry, const QString& file) {
  if (file.isEmpty()) return false;
  QFile in(file + QStringLiteral(".json"));
  if (!in.open(QIODevice::ReadOnly)) return false;
  const QJsonObject object = QJsonDocument::fromJson(in.readAll()).object();
  if (object.isEmpty()) return false;
  const auto texts = [&object](const char* key) {
    QStringList list;
    for (const QJsonValue& value : object[QLatin1String(key)].toArray()) list << value.toString();
    return list;
  };
  entry.grade = object["grade"].toString(), entry.graded = object["graded"].toBool();
  entry.reason = object["reason"].toString();
  entry.structures = texts("structures"), entry.errors = texts("errors"), entry.warnings = texts("warnings");
  entry.fit = object["fit"].toBool();
  entry.slice.load(file + QStringLiteral("-ct.png"));
  entry.ultrasound.load(file + QStringLiteral("-us.png"));
  entry.state = LibraryEntry::State::Known;
  return true;
}

LibraryEntry broken(LibraryEntry entry, const std::string& why) {
  entry.state = LibraryEntry::State::Broken;
  entry.error = QString::fromStdString(why);
  return entry;
}

void addCases(const QString& folder, int deeper, QStringList& into) {
  const QString found = caseFolderOf(folder);
  if (!found.isEmpty()) {
    into << found;
    return;
  }
  if (deeper == 0) return;
  removeAbandonedParts(folder.toStdString());
  const QDir dir(folder);
  for (const QString& name : dir.entryList(QDir::Dirs | QDir::NoDotAndDotDot | QDir::Readable))
    addCases(dir.filePath(name), deeper - 1, into);
}

}  // namespace

QString libraryCache() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).filePath(QStringLiteral("library"));
}

QStringList casesIn(const QStringList& folders) {
  constexpr int kDeep = 2;
  QStringList cases;
  for (const QString& folder : folders) addCases(folder, kDeep, cases);
  cases.removeDuplicates();
  cases.sort(Qt::CaseInsensitive);
  return cases;
}

LibraryEntry listedCase(const QString& place, bool builtIn) {
  LibraryEntry entry;
  entry.place = place, entry.builtIn = builtIn;
  if (builtIn) {
    const auto all = phantomVariants();
    const auto found = std::ranges::find_if(all, [&](const PhantomVariant& v) { return qt(v.name) == place; });
    if (found != all.end()) entry.title = qt(found->title), entry.description = qt(found->description);
    return entry;
  }
  entry.title = QFileInfo(place).fileName();
  const auto manifest = readCaseManifest(place.toStdString());
  if (!manifest) return broken(std::move(entry), manifest.error().message);
  if (!manifest->title.empty() && manifest->title != CaseManifest{}.title)
    entry.title = QString::fromStdString(manifest->title);
  entry.description = QString::fromStdString(manifest->description);
  entry.version = manifest->version.number, entry.date = QString::fromStdString(manifest->version.date);
  return entry;
}

LibraryEntry knownCase(LibraryEntry entry, const QString& cache, const Progress& progress) {
  if (entry.state == LibraryEntry::State::Broken) return entry;
  const QString folder = entry.builtIn ? builtInFolder(entry.place) : entry.place;
  if (takeKept(entry, keptFile(cache, entry, folder))) return entry;
  if (entry.builtIn) {
    const auto made = builtInCase(entry.place, folder, progress);
    if (!made) return broken(std::move(entry), made.error().message);
    findOut(**made, entry, progress);
    // The next start reads the neck from the disk: only then is its fingerprint known.
    waitForBuiltInCache();
  } else {
    const auto read = readCase(folder.toStdString());
    if (!read) return broken(std::move(entry), read.error().message);
    findOut(read->patient, entry, progress);
  }
  if (entry.state == LibraryEntry::State::Known) keep(entry, keptFile(cache, entry, folder));
  return entry;
}

}  // namespace insonate::ui
