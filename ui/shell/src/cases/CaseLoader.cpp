#include "BuiltInCase.h"
#include "CaseEdits.h"
#include "SeriesDialog.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseTitle.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/KnownCases.h>
#include <insonate/ui/TaskBar.h>

#include <QDir>
#include <QFileInfo>
#include <QImageReader>
#include <algorithm>
#include <filesystem>
#include <utility>

namespace insonate::ui {
namespace {

namespace fs = std::filesystem;

bool holdsCase(const QDir& folder) {
  return folder.exists(QStringLiteral("case.json")) ||
         (folder.exists(QStringLiteral("ct.nrrd")) &&
          (folder.exists(QStringLiteral("labels.seg.nrrd")) || folder.exists(QStringLiteral("labels.nrrd"))));
}

QStringList listOf(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const std::string& sentence : sentences) list << QString::fromStdString(sentence);
  return list;
}

/// Part `index` of `count` of one progress.
Progress part(const Progress& whole, int index, int count) {
  return [whole, index, count](std::string_view doing, double fraction) {
    return report(whole, doing, (index + fraction) / count);
  };
}

Result<LoadedCase> importCase(const fs::path& input, const ImportChoice& choice, const Progress& progress) {
  const int parts = choice.label ? 2 : 1;
  Result<ImportedCt> imported =
      choice.read ? Result<ImportedCt>(*choice.read) : importSeries(input, choice.uid, part(progress, 0, parts));
  if (!imported) return tl::unexpected(imported.error());
  // The user may import before the series was read for the preview.
  if (imported->saturatedVoxels > 0 && !choice.saturate)
    return fail(saturationText(*imported) + " Import the series again and confirm this in the dialog.");
  if (choice.shift_HU) shiftValues(*imported, *choice.shift_HU);
  LoadedCase result;
  auto patient = std::make_shared<PatientCase>();
  patient->manifest.title = kImportedTitle;
  patient->manifest.source = imported->source;
  patient->manifest.importNotes = imported->series.warnings;
  patient->ct = std::move(imported->ct);
  patient->labels = LabelMap(patient->ct.geometry);
  if (choice.label) {
    auto labels = autoLabel(patient->ct, part(progress, 1, parts));
    if (!labels && labels.error().message == kCancelled) return tl::unexpected(labels.error());
    if (labels) {
      patient->labels = std::move(*labels);
      patient->manifest.source += " Labeled automatically from Hounsfield units.";
    } else {
      patient->manifest.importNotes.push_back("Nothing could be labeled: " + labels.error().message);
    }
  }
  result.notes = listOf(patient->manifest.importNotes);
  result.patient = std::move(patient);
  return result;
}

/// Tells whether another program saved other content there meanwhile. A case without a version gets one when it is
/// published.
bool holdsAnother(const fs::path& folder, const std::string& known, const PatientCase& patient) {
  const auto there = readCaseManifest(folder);
  if (!there || there->version.content.empty() || there->version.content == known) return false;
  return !known.empty() || there->version.content != contentHashOf(patient);
}

}  // namespace

QString caseFolderOf(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return holdsCase(QDir(path)) ? QDir(path).absolutePath() : QString();
  const QDir folder = info.absoluteDir();
  const bool inside = info.exists() && isCaseFile(folder.path().toStdString(), path.toStdString());
  return inside && holdsCase(folder) ? folder.absolutePath() : QString();
}

CaseLoader::CaseLoader(TaskBar& tasks, QWidget* dialogParent)
    : QObject(dialogParent), tasks_(tasks), dialogParent_(dialogParent) {}

CaseLoader::~CaseLoader() = default;

void CaseLoader::refuse(const Error& error, const QString& advice) {
  if (error.message == kCancelled)
    Q_EMIT cancelled();
  else
    Q_EMIT failed(QString::fromStdString(error.message), advice, {});
}

void CaseLoader::open(const QString& path) {
  if (dialog_) dialog_->reject();
  if (!QFileInfo::exists(path)) {
    return Q_EMIT failed(tr("There is no file or folder '%1'.").arg(path),
                         tr("Check the name, or choose a file or folder with Open case."), {});
  }
  const QString folder = caseFolderOf(path);
  if (folder.isEmpty())
    list(path);
  else
    readFolder(folder);
}

void CaseLoader::readFolder(const QString& folder) {
  tasks_.run<LoadedCase>(
      tr("Opening %1").arg(QFileInfo(folder).fileName()),
      [folder](const Progress& progress) -> Result<LoadedCase> {
        report(progress, "reading CT and labels", 0);
        auto read = readCase(folder.toStdString());
        if (!read) return tl::unexpected(read.error());
        LoadedCase result{std::make_shared<PatientCase>(std::move(read->patient)), folder, listOf(read->notes)};
        result.content = result.patient->manifest.version.content;
        result.readFrom = folder;
        // Versions and downloaded cases never change.
        if (const auto whole = caseOfVersion(folder.toStdString()))
          result.versionOf = QString::fromStdString(whole->string()), result.folder.clear();
        else if (isDownloaded(folder))
          result.versionOf = folder, result.folder.clear();
        return result;
      },
      [this](Result<LoadedCase> read) {
        if (!read) return refuse(read.error(), tr("The case was not opened; the present case stays open."));
        Q_EMIT loaded(*read);
      });
}

void CaseLoader::list(const QString& path) {
  using Listing = std::shared_ptr<const SeriesListing>;
  tasks_.run<Listing>(
      tr("Reading %1").arg(QFileInfo(path).fileName()),
      [path](const Progress& progress) -> Result<Listing> {
        auto listing = listSeries(path.toStdString(), progress);
        if (!listing) return tl::unexpected(listing.error());
        return std::make_shared<const SeriesListing>(std::move(*listing));
      },
      [this, path](Result<Listing> listing) {
        if (!listing) {
          const bool picture = !QImageReader::imageFormat(path).isEmpty();
          return refuse(
              listing.error(),
              picture ? tr("This file is an image, not a case or a CT. To fit a probe to a scanner's image, switch to "
                           "Train (Ctrl+2) and choose Edit beside the probe, then Fit probe geometry to an image.")
                      : tr("You can open a case folder, a folder of DICOM files, or an NRRD, NIfTI or "
                           "MetaImage file here."));
        }
        choose(path, *listing);
      });
}

void CaseLoader::choose(const QString& path, std::shared_ptr<const SeriesListing> listing) {
  dialog_ = new SeriesDialog(path, std::move(listing), dialogParent_);
  dialog_->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog_, &SeriesDialog::accepted, this, [this, path] { import(path, dialog_->choice()); });
  connect(dialog_, &SeriesDialog::rejected, this, &CaseLoader::cancelled);
  dialog_->open();
}

void CaseLoader::import(const QString& path, const ImportChoice& choice) {
  tasks_.run<LoadedCase>(
      tr("Importing %1").arg(QFileInfo(path).fileName()),
      [path, choice](const Progress& progress) { return importCase(path.toStdString(), choice, progress); },
      [this](Result<LoadedCase> imported) {
        if (!imported) return refuse(imported.error(), tr("Nothing was imported; the present case stays open."));
        Q_EMIT loaded(*imported);
      },
      TaskBar::WhenClosed::Ask);
}

void CaseLoader::openBuiltIn(const QString& variant) {
  if (dialog_) dialog_->reject();
  const QString folder = builtInFolder(variant);
  tasks_.run<LoadedCase>(
      tr("Opening the built-in case"),
      [variant, folder](const Progress& progress) -> Result<LoadedCase> {
        auto made = builtInCase(variant, folder, progress);
        if (!made) return tl::unexpected(made.error());
        LoadedCase result;
        result.patient = std::move(*made);
        result.builtIn = true;
        return result;
      },
      [this](Result<LoadedCase> made) {
        if (!made) return refuse(made.error(), tr("Open a case of your own instead."));
        Q_EMIT loaded(*made);
      });
}

void CaseLoader::save(std::shared_ptr<const PatientCase> patient, const QString& folder, std::vector<CaseEdit> edits,
                      const std::optional<std::string>& content) {
  if (patient->manifest.title == kImportedTitle)
    edits.push_back([folder](PatientCase& copy) { setTitleFromFolder(copy.manifest, folder.toStdString()); });
  tasks_.run<SavedCase>(
      tr("Saving to %1").arg(QFileInfo(folder).fileName()),
      [patient = std::move(patient), folder, edits = std::move(edits),
       content](const Progress& progress) -> Result<SavedCase> {
        const fs::path target = folder.toStdString();
        if (auto ok = checkCaseTarget(target, true); !ok) return tl::unexpected(ok.error());
        SavedCase saved{folder, withEdits(patient, edits), {}, content && holdsAnother(target, *content, *patient)};
        const auto version =
            saveCaseVersion(*saved.patient, target, today(), saved.patient->manifest.version.author, progress);
        if (!version) return tl::unexpected(version.error());
        saved.content = version->content;
        return saved;
      },
      [this](Result<SavedCase> written) {
        if (!written) return refuse(written.error(), tr("The case is still open; save the case to another folder."));
        Q_EMIT saved(*written);
      },
      TaskBar::WhenClosed::Ask);
}

}  // namespace insonate::ui
