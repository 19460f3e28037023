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
#include <utility>

namespace insonate::train {

ImageExports::ImageExports(const Sources& sources, ui::Workspace& workspace, QObject* parent)
    : QObject(parent), sources_(sources), workspace_(workspace) {
  connect(&sources_.cine, &CineBar::saveScreen, this, [this] { askScreen(); });
  connect(&sources_.cine, &CineBar::saveClip, this, [this] { askClip(); });
}

std::vector<views::Calliper> ImageExports::measurements() const {
  return sources_.cine.savesMeasurements() ? sources_.input.callipers().done() : std::vector<views::Calliper>();
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
      Q_EMIT workspace_.failed(QString::fromStdString(result.error().message), tr("The image is still shown."), {});
  };
  writers_.push_back(std::make_unique<PictureWriter>(std::move(make), file, ended));
}

void ImageExports::savePicture(const std::filesystem::path& file) {
  if (!sources_.live.shown()) return sources_.status.say(tr("There is no image yet."));
  startWriting(
      [frame = sources_.live.shown(), callipers = measurements()] { return scaledPicture(frame->image, callipers); },
      file);
}

void ImageExports::saveScreen(const std::filesystem::path& file) {
  if (!sources_.live.shown()) return sources_.status.say(tr("There is no image yet."));
  startWriting([screen = sources_.panes.grab().toImage()] { return screen; }, file);
}

void ImageExports::saveClip(const std::filesystem::path& folder) {
  sources_.live.setFrozen(true);
  if (sources_.live.cine().empty()) return sources_.status.say(tr("There is no image yet."));
  ui::TaskBar& tasks = workspace_.tasks();
  if (tasks.isRunning()) return sources_.status.say(tr("Wait until the other job is done, or cancel that job."));
  tasks.run<int>(
      tr("Saving the clip"),
      [frames = sources_.live.cine(), callipers = measurements(), folder](const Progress& progress) {
        return writeClip(frames, callipers, folder, progress);
      },
      [this, folder](Result<int> result) {
        if (result)
          Q_EMIT workspace_.written(tr("Clip saved as a folder of %1 PNG images.").arg(*result),
                                    QString::fromStdString(folder.string()));
        else if (result.error().message == kCancelled)
          sources_.status.say(tr("The clip was not saved."));
        else
          Q_EMIT workspace_.failed(QString::fromStdString(result.error().message),
                                   tr("The images are still in memory, so you can save the clip again."), {});
      },
      ui::TaskBar::WhenClosed::Ask);
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
  if (!sources_.live.shown()) return sources_.status.say(tr("There is no image yet."));
  const bool wasFrozen = sources_.live.isFrozen();
  sources_.live.setFrozen(true);  // The image that the user saw, whatever the dialog takes.
  const QString file = askFile(tr("Save the image"), ".png");
  if (!file.isEmpty()) savePicture(file.toStdString());
  // With measurements the image stays frozen, since they belong to it.
  if (!wasFrozen && sources_.input.callipers().done().empty()) sources_.live.setFrozen(false);
}

void ImageExports::askScreen() {
  if (!sources_.live.shown()) return sources_.status.say(tr("There is no image yet."));
  // As it was when it was asked for, whatever the dialog takes.
  const QImage screen = sources_.panes.grab().toImage();
  const QString file = askFile(tr("Save the image as displayed"), "-screen.png");
  if (!file.isEmpty()) startWriting([screen] { return screen; }, file.toStdString());
}

void ImageExports::askClip() {
  sources_.live.setFrozen(true);
  const QString folder = QFileDialog::getExistingDirectory(
      &workspace_, tr("Save the clip: choose where to create a folder of numbered PNG images"), folder_);
  if (folder.isEmpty() || !sources_.patientCase.patient()) return;
  folder_ = folder;
  const QString name = exportName(QString::fromStdString(sources_.patientCase.patient()->manifest.title));
  saveClip(QDir(folder).filePath(name).toStdString());
}

void ImageExports::save(QSettings& settings) const {
  settings.setValue("exportFolder", folder_);
}

void ImageExports::restore(QSettings& settings) {
  folder_ = settings.value("exportFolder").toString();
}

}  // namespace insonate::train
