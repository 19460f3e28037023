#include "ImageExports.h"

#include "../model/CaseModel.h"
#include "../model/LiveModel.h"
#include "../model/StatusLine.h"
#include "CineBar.h"
#include "EqualPanes.h"
#include "ImageInput.h"
#include "ScaledPicture.h"

#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Workspace.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <QUuid>
#include <algorithm>
#include <array>
#include <utility>

namespace insonate::train {
namespace {

struct ClipKind {
  const char *filter, *ending;
};
/// In the order of ClipFormat.
constexpr std::array<ClipKind, 3> kClipKinds{
    {{"Video (*.webm)", "webm"}, {"DICOM ultrasound clip (*.dcm)", "dcm"}, {"Images (*.png)", "png"}}};

}  // namespace

ImageExports::ImageExports(const Sources& sources, ui::Workspace& workspace, QObject* parent)
    : QObject(parent), sources_(sources), workspace_(workspace) {
  connect(&sources_.cine, &CineBar::saveScreen, this, [this] { askScreen(); });
  connect(&sources_.cine, &CineBar::saveClip, this, [this] { askClip(); });
}

std::vector<views::Caliper> ImageExports::measurements() const {
  return sources_.cine.savesMeasurements() ? sources_.input.calipers().done() : std::vector<views::Caliper>();
}

void ImageExports::startWriting(std::function<QImage()> make, const std::filesystem::path& file) {
  // Earlier exports have long ended, or are waited for.
  constexpr std::size_t kAtOnce = 4;
  if (writers_.size() >= kAtOnce) writers_.erase(writers_.begin());
  const QFileInfo info(QString::fromStdString(file.string()));
  const auto ended = [this, info](const Result<void>& result) {
    if (result)
      Q_EMIT workspace_.written(tr("Image saved as %1.").arg(info.fileName()), info.absolutePath());
    else
      Q_EMIT workspace_.failed(QString::fromStdString(result.error().message),
                               tr("The image is still shown, so you can save it again."), {});
  };
  writers_.push_back(std::make_unique<ImageWriter>(std::move(make), file, ended));
}

void ImageExports::saveImage(const std::filesystem::path& file) {
  if (!sources_.live.shown()) return sources_.status.showMessage(tr("There is no image yet."));
  startWriting([frame = sources_.live.shown(), calipers = measurements()] { return scaledPicture(*frame, calipers); },
               file);
}

void ImageExports::saveScreen(const std::filesystem::path& file) {
  if (!sources_.live.shown()) return sources_.status.showMessage(tr("There is no image yet."));
  startWriting([screen = sources_.panes.grab().toImage()] { return screen; }, file);
}

void ImageExports::saveClip(const std::filesystem::path& target) {
  sources_.live.setFrozen(true);
  if (sources_.live.cine().empty()) return sources_.status.showMessage(tr("There is no image yet."));
  ui::TaskBar& tasks = workspace_.tasks();
  if (tasks.isRunning())
    return sources_.status.showMessage(
        tr("Another job is running. Wait until it is done, or cancel it, then save the clip."));
  const SavedClip clip{sources_.live.cine(), measurements(), sources_.patientCase.patient(),
                       QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString()};
  tasks.run<int>(
      tr("Saving the clip"), [clip, target](const Progress& progress) { return writeClip(clip, target, progress); },
      [this, target, shown = clip.frames.size()](Result<int> result) {
        if (result)
          showSaved(target, *result, shown);
        else if (result.error().message == kCancelled)
          sources_.status.showMessage(tr("The clip was not saved."));
        else
          Q_EMIT workspace_.failed(QString::fromStdString(result.error().message),
                                   tr("The images are still in memory, so you can save the clip again."), {});
      },
      ui::TaskBar::WhenClosed::Ask);
}

void ImageExports::showSaved(const std::filesystem::path& clip, int images, std::size_t shown) {
  const QFileInfo info(QString::fromStdString(clip.string()));
  if (clipFormatOf(clip) == ClipFormat::Images)
    return Q_EMIT workspace_.written(tr("Clip saved as a folder of %1 PNG images.").arg(images), info.filePath());
  const QString left =
      std::size_t(images) == shown
          ? QString()
          : tr(" It contains only the %1 images since the last change of depth or image size.").arg(images);
  Q_EMIT workspace_.written(tr("Clip saved as %1.").arg(info.fileName()) + left, info.absolutePath());
}

QString ImageExports::askFile(const QString& title, const QString& ending) {
  const QString name = exportName(QString::fromStdString(sources_.patientCase.patient()->manifest.title)) + ending;
  QString file =
      QFileDialog::getSaveFileName(&workspace_, title, QDir(folder_).filePath(name), tr("PNG image (*.png)"));
  if (file.isEmpty()) return {};
  if (QFileInfo(file).suffix().isEmpty()) file += ".png";
  folder_ = QFileInfo(file).path();
  return file;
}

void ImageExports::askPicture() {
  if (!sources_.live.shown()) return sources_.status.showMessage(tr("There is no image yet."));
  const bool wasFrozen = sources_.live.isFrozen();
  sources_.live.setFrozen(true);  // The image that the user saw, whatever the dialog takes.
  const QString file = askFile(tr("Save the image"), ".png");
  if (!file.isEmpty()) saveImage(file.toStdString());
  // With measurements the image stays frozen, since they belong to it.
  if (!wasFrozen && sources_.input.calipers().done().empty()) sources_.live.setFrozen(false);
}

void ImageExports::askScreen() {
  if (!sources_.live.shown()) return sources_.status.showMessage(tr("There is no image yet."));
  // As it was when it was asked for, whatever the dialog takes.
  const QImage screen = sources_.panes.grab().toImage();
  const QString file = askFile(tr("Save the image as displayed"), "-screen.png");
  if (!file.isEmpty()) startWriting([screen] { return screen; }, file.toStdString());
}

void ImageExports::askClip() {
  sources_.live.setFrozen(true);
  if (!sources_.patientCase.patient()) return;
  QFileDialog dialog(&workspace_, tr("Save the clip"), folder_);
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  QStringList filters;
  for (const ClipKind& kind : kClipKinds) filters << tr(kind.filter);
  dialog.setNameFilters(filters);
  const auto choose = [&](const QString& filter) {
    clipFormat_ = ClipFormat(std::max(0, filters.indexOf(filter)));
    dialog.setDefaultSuffix(kClipKinds[std::size_t(clipFormat_)].ending);
  };
  connect(&dialog, &QFileDialog::filterSelected, this, choose);
  dialog.selectNameFilter(filters[int(clipFormat_)]);
  choose(filters[int(clipFormat_)]);
  dialog.selectFile(exportName(QString::fromStdString(sources_.patientCase.patient()->manifest.title)));
  if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return;
  const QString file = withEnding(dialog.selectedFiles().first());
  if (file.isEmpty()) return;
  const QFileInfo chosen(file);
  folder_ = chosen.path();
  // Images fill a folder, which has the name without the ending.
  const bool isFolder = chosen.suffix() == kClipKinds[std::size_t(ClipFormat::Images)].ending;
  saveClip((isFolder ? QDir(chosen.path()).filePath(chosen.completeBaseName()) : file).toStdString());
}

QString ImageExports::withEnding(const QString& file) {
  const QString ending = QFileInfo(file).suffix();
  if (std::ranges::any_of(kClipKinds, [&](const ClipKind& kind) { return ending == kind.ending; })) return file;
  // The dialog adds an ending only to a name without a dot, and has not asked about this name.
  const QString whole = file + "." + kClipKinds[std::size_t(clipFormat_)].ending;
  if (!QFileInfo::exists(whole)) return whole;
  Q_EMIT workspace_.failed(tr("%1 already exists.").arg(whole), tr("Save the clip again under another name."), {});
  return {};
}

void ImageExports::save(QSettings& settings) const {
  settings.setValue("exportFolder", folder_);
  settings.setValue("clipFormat", int(clipFormat_));
}

void ImageExports::restore(QSettings& settings) {
  folder_ = settings.value("exportFolder").toString();
  clipFormat_ = ClipFormat(std::clamp(settings.value("clipFormat").toInt(), 0, int(kClipKinds.size()) - 1));
}

}  // namespace insonate::train
