#include "CaseExchange.h"

#include "CaseEdits.h"
#include "CropDialog.h"
#include "LabelsDialog.h"
#include "SourceDialog.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/cases/DicomWriter.h>
#include <insonate/cases/LabelFile.h>
#include <insonate/simulator/ImportedLabels.h>
#include <insonate/surface/SurfaceFiles.h>
#include <insonate/ui/TaskBar.h>

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QSettings>
#include <filesystem>
#include <utility>

namespace insonate::ui {
namespace {

const QString kLastExport = QStringLiteral("lastExport");
/// Property of an action: its tooltip while it is enabled.
constexpr const char* kTip = "tip";

using Made = std::shared_ptr<const PatientCase>;

Result<void> writeSeries(const PatientCase& patient, const std::string& folder, const Progress& progress) {
  return writeDicomSeries(patient.ct, folder, dicomIdentityOf(patient), progress);
}

std::function<Result<void>(const PatientCase&, const std::string&, const Progress&)> writeMeshes(const char* format) {
  return [format](const PatientCase& patient, const std::string& folder, const Progress& progress) -> Result<void> {
    const auto written = writeSurfaces(patient.labels, folder, format, {}, progress);
    if (!written) return tl::unexpected(written.error());
    return {};
  };
}

}  // namespace

CaseExchange::CaseExchange(TaskBar& tasks, std::function<OpenCase()> open, QWidget* window)
    : QObject(window), tasks_(tasks), open_(std::move(open)), window_(window) {
  undo_ = add(tr("Undo label import"), tr("Restores the labels that this case had before the last import of labels"),
              "undoImportLabels", [this] { undoImport(); });
  ways_ = {add(tr("Import labels ..."), tr("Replaces this case's labels with labels from another program"),
               "importLabels", [this] { chooseLabels(); }),
           undo_,
           add(tr("Crop and resample ..."),
               tr("Makes a new case from a part of this case, optionally with another voxel spacing"), "cropCase",
               [this] { chooseCrop(); })};
  exports_ = {
      addExport(tr("Export CT as DICOM series ..."), tr("Exports the CT to a new folder, one file for each slice"),
                "exportDicom", {}, writeSeries),
      addExport(tr("Export labels as DICOM segmentation ..."),
                tr("Exports the labels as a DICOM segmentation that belongs to the exported DICOM series of the CT"),
                "exportSeg", QStringLiteral(".dcm"),
                [](const PatientCase& patient, const std::string& file, const Progress& progress) {
                  return writeDicomSegmentation(patient, file, progress);
                }),
      addExport(tr("Export labels for 3D Slicer and ITK-SNAP ..."),
                tr("Exports the labels to a segmentation file, with a label description file for ITK-SNAP"),
                "exportLabels", QStringLiteral(".seg.nrrd"),
                [](const PatientCase& patient, const std::string& file, const Progress& progress) {
                  return writeLabelFile(patient, file, progress);
                }),
      addExport(tr("Export meshes (STL) ..."),
                tr("Exports the surface of each structure to a new folder, in patient coordinates (LPS, mm)"),
                "exportStl", {}, writeMeshes("stl")),
      addExport(tr("Export meshes (OBJ) ..."),
                tr("Exports the surface of each structure to a new folder, in patient coordinates (LPS, mm)"),
                "exportObj", {}, writeMeshes("obj")),
      addExport(tr("Export meshes (VTP) ..."),
                tr("Exports the surface of each structure to a new folder, in patient coordinates (LPS, mm)"),
                "exportVtp", {}, writeMeshes("vtp"))};
  setObstacle(tr("Open a case first."));
}

QAction* CaseExchange::add(const QString& text, const QString& tip, const char* name, std::function<void()> go) {
  auto* action = new QAction(text, this);
  action->setToolTip(tip);
  action->setProperty(kTip, tip);
  action->setObjectName(QLatin1String(name));
  connect(action, &QAction::triggered, this, std::move(go));
  return action;
}

QAction* CaseExchange::addExport(const QString& text, const QString& tip, const char* name, const QString& ending,
                                 Write write) {
  return add(text, tip, name,
             [this, title = QString(text).remove(QStringLiteral(" ...")), ending, write = std::move(write)] {
               chooseTarget(title, ending, write);
             });
}

void CaseExchange::addTo(QMenu& menu) {
  for (QAction* action : ways_) menu.addAction(action);
  QMenu* out = menu.addMenu(tr("Export"));
  out->setToolTipsVisible(true);
  for (QAction* action : exports_) out->addAction(action);
}

void CaseExchange::setObstacle(const QString& reason) {
  const auto offer = [&reason](QAction* action) {
    const QString tip = action->property(kTip).toString();
    action->setEnabled(reason.isEmpty());
    action->setToolTip(reason.isEmpty() ? tip : QStringLiteral("%1. %2").arg(tip, reason));
  };
  for (QAction* action : ways_) offer(action);
  for (QAction* action : exports_) offer(action);
  if (!former_ || withImported_.lock() != open_().patient) undo_->setEnabled(false);
}

void CaseExchange::chooseLabels() {
  const QString source = askForSourceFileOrFolder(
      window_, tr("Import labels"), tr("Labels (*.dcm *.nrrd *.nhdr *.nii *.nii.gz *.mha *.mhd);;All files (*)"));
  if (!source.isEmpty()) importLabels(source);
}

/// The open case with its unsaved changes, and labels that are not in it yet.
struct CaseExchange::Imported {
  std::filesystem::path source;
  NumberMeaning meaning;
  Made from;  ///< the open case, as it was stored
  std::shared_ptr<PatientCase> copy;
  LabelReadResult labels;
  LabelsPreview preview;
};

void CaseExchange::importLabels(const QString& file, const QString& names) {
  tasks_.run<std::shared_ptr<Imported>>(
      tr("Reading labels"),
      [open = open_(), file, names](const Progress& progress) -> Result<std::shared_ptr<Imported>> {
        auto copy = std::make_shared<PatientCase>(*withEdits(open.patient, open.edits));
        // Numbers without names are shown before they are taken.
        const NumberMeaning meaning{.names = names.toStdString(), .areProgramLabels = true};
        const std::filesystem::path source(file.toStdString());
        auto labels = insonate::importLabels(*copy, source, meaning, progress);
        if (!labels) return tl::unexpected(labels.error());
        auto preview = labelsPreviewOf(copy->ct, *labels);
        return std::make_shared<Imported>(
            Imported{source, meaning, open.patient, std::move(copy), std::move(*labels), std::move(preview)});
      },
      [this, file](Result<std::shared_ptr<Imported>> imported) {
        if (!imported) return refuse(imported.error(), tr("The labels of the case are unchanged."));
        showLabels(file, *imported);
      });
}

void CaseExchange::showLabels(const QString& file, const std::shared_ptr<Imported>& imported) {
  auto* dialog = new LabelsDialog(QFileInfo(file).fileName(), imported->labels, imported->preview, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &LabelsDialog::namesRequested, this, [this, file] {
    const QString names = askForSourceFile(window_, tr("Choose a file with the names of the labels"),
                                           tr("Label names (*.txt *.label *.ctbl *.json);;All files (*)"));
    if (!names.isEmpty()) importLabels(file, names);
  });
  connect(dialog, &QDialog::accepted, this, [this, dialog, imported] {
    imported->meaning.choices = dialog->choices();
    takeLabels(imported, dialog->labelsRest());
  });
  dialog->open();
}

void CaseExchange::takeLabels(const std::shared_ptr<Imported>& imported, bool labelsRest) {
  if (open_().patient != imported->from)
    return Q_EMIT failed(tr("The case was changed during the preview of the new labels."),
                         tr("Import the labels again."), {});
  tasks_.run<std::shared_ptr<Imported>>(
      tr("Importing labels"),
      [imported, labelsRest](const Progress& progress) -> Result<std::shared_ptr<Imported>> {
        const StructureChoices& choices = imported->meaning.choices;
        if (!choices.taken.empty() || !choices.sides.empty()) {
          auto again = insonate::importLabels(*imported->copy, imported->source, imported->meaning, progress);
          if (!again) return tl::unexpected(again.error());
          imported->labels = std::move(*again);
        }
        if (auto ok = makeImportedVessels(imported->labels, progress); !ok) return tl::unexpected(ok.error());
        if (labelsRest)
          if (auto ok = labelRest(imported->copy->ct, imported->labels, progress); !ok)
            return tl::unexpected(ok.error());
        return imported;
      },
      [this](Result<std::shared_ptr<Imported>> done) {
        if (!done) return refuse(done.error(), tr("The labels of the case are unchanged."));
        Imported& ready = **done;
        if (open_().patient != ready.from)
          return Q_EMIT failed(tr("The case was changed during the import of the labels."),
                               tr("Import the labels again."), {});
        QStringList notes;
        for (const std::string& note : ready.labels.notes) notes << QString::fromStdString(note);
        former_ = std::make_shared<PatientCase>(
            PatientCase{ready.copy->manifest, {}, std::move(ready.copy->labels), std::move(ready.copy->colors)});
        replaceLabels(std::move(ready.labels), *ready.copy);
        withImported_ = ready.copy;
        Q_EMIT labelsReplaced(ready.copy, tr("Labels imported. %1").arg(notes.join(QLatin1Char(' '))));
      });
}

void CaseExchange::undoImport() {
  if (!open_().edits.empty())
    return Q_EMIT failed(tr("The case was edited after the import of the labels."), tr("Undo these edits first."), {});
  tasks_.run<Made>(
      tr("Restoring labels"),
      [open = open_(), former = former_](const Progress&) -> Result<Made> {
        return std::make_shared<const PatientCase>(
            PatientCase{former->manifest, open.patient->ct, former->labels, former->colors});
      },
      [this, from = open_().patient](Result<Made> restored) {
        if (!restored || open_().patient != from) return;
        former_.reset();
        Q_EMIT labelsReplaced(*restored, tr("The labels before the import were restored."));
      });
}

void CaseExchange::chooseCrop() {
  auto* dialog = new CropDialog(open_().patient, window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog] { crop(dialog->options()); });
  dialog->open();
}

void CaseExchange::crop(const CropOptions& options) {
  const std::size_t before = open_().patient->manifest.importNotes.size();
  tasks_.run<Made>(
      tr("Cropping"),
      [open = open_(), options](const Progress& progress) -> Result<Made> {
        auto part = cropCase(*withEdits(open.patient, open.edits), options, progress);
        if (!part) return tl::unexpected(part.error());
        return std::make_shared<const PatientCase>(std::move(*part));
      },
      [this, before](Result<Made> part) {
        if (!part) return refuse(part.error(), tr("The case is unchanged."));
        QStringList changes;
        const auto& notes = (*part)->manifest.importNotes;
        for (std::size_t n = before; n < notes.size(); ++n) changes << QString::fromStdString(notes[n]);
        Q_EMIT made(*part, changes.join(QLatin1Char(' ')));
      },
      TaskBar::WhenClosed::Ask);
}

void CaseExchange::chooseTarget(const QString& title, const QString& ending, const Write& write) {
  QFileDialog dialog(window_, title, QSettings().value(kLastExport, QDir::homePath()).toString());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  if (ending.isEmpty()) {
    dialog.setOption(QFileDialog::ShowDirsOnly);
    dialog.setLabelText(QFileDialog::FileName, tr("New folder:"));
  } else {
    dialog.setNameFilter(tr("Labels (*%1)").arg(ending));
    dialog.setDefaultSuffix(ending.mid(1));
  }
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString target = dialog.selectedFiles().first();
  QSettings().setValue(kLastExport, QFileInfo(target).absolutePath());
  this->write(target, write);
}

void CaseExchange::write(const QString& target, const Write& write) {
  tasks_.run<bool>(
      tr("Exporting to %1").arg(QFileInfo(target).fileName()),
      [open = open_(), target, write](const Progress& progress) -> Result<bool> {
        if (auto ok = write(*withEdits(open.patient, open.edits), target.toStdString(), progress); !ok)
          return tl::unexpected(ok.error());
        return true;
      },
      [this, target](Result<bool> done) {
        if (!done) return refuse(done.error(), tr("Nothing was exported; choose another folder or name."));
        Q_EMIT written(tr("Exported to %1.").arg(target), QFileInfo(target).absolutePath());
      },
      TaskBar::WhenClosed::Ask);
}

void CaseExchange::refuse(const Error& error, const QString& advice) {
  if (error.message != kCancelled) Q_EMIT failed(QString::fromStdString(error.message), advice, {});
}

}  // namespace insonate::ui
