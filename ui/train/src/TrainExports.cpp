// The part of the workspace that writes images and clips.
#include "TrainParts.h"
#include "files/ScaledPicture.h"
#include "image/CineBar.h"
#include "image/EqualPanes.h"
#include "image/ImageInput.h"

#include <insonate/ui/TaskBar.h>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

namespace insonate::train {

std::vector<views::Calliper> TrainWorkspace::Parts::measurements() const {
  return cine_->savesMeasurements() ? input_->callipers().done() : std::vector<views::Calliper>();
}

void TrainWorkspace::Parts::startWriting(std::function<QImage()> make, const std::filesystem::path& file) {
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

void TrainWorkspace::Parts::savePicture(const std::filesystem::path& file) {
  if (!model.live.shown()) return model.status.say(tr("There is no image yet."));
  startWriting(
      [frame = model.live.shown(), callipers = measurements()] { return scaledPicture(frame->image, callipers); },
      file);
}

void TrainWorkspace::Parts::saveScreen(const std::filesystem::path& file) {
  if (!model.live.shown()) return model.status.say(tr("There is no image yet."));
  startWriting([screen = pictures_->grab().toImage()] { return screen; }, file);
}

void TrainWorkspace::Parts::saveClip(const std::filesystem::path& folder) {
  model.live.setFrozen(true);
  if (model.live.cine().empty()) return model.status.say(tr("There is no image yet."));
  ui::TaskBar& tasks = workspace_.tasks();
  if (tasks.isRunning()) return model.status.say(tr("Wait until the other job is done, or cancel it."));
  tasks.run<int>(
      tr("Saving the clip"),
      [frames = model.live.cine(), callipers = measurements(), folder](const Progress& progress) {
        return writeClip(frames, callipers, folder, progress);
      },
      [this, folder](Result<int> result) {
        if (result)
          Q_EMIT workspace_.written(tr("Clip saved as a folder of %1 PNG images.").arg(*result),
                                    QString::fromStdString(folder.string()));
        else if (result.error().message == kCancelled)
          model.status.say(tr("The clip was not saved."));
        else
          Q_EMIT workspace_.failed(QString::fromStdString(result.error().message), tr("The images are still here."),
                                   {});
      },
      ui::TaskBar::WhenClosed::Ask);
}

QString TrainWorkspace::Parts::askFile(const QString& title, const QString& ending) {
  const QString name = exportName(QString::fromStdString(model.patientCase.patient()->manifest.title)) + ending;
  QString file =
      QFileDialog::getSaveFileName(&workspace_, title, QDir(exportFolder).filePath(name), tr("PNG image (*.png)"));
  if (file.isEmpty()) return {};
  if (QFileInfo(file).suffix().isEmpty()) file += ".png";
  exportFolder = QFileInfo(file).path();
  return file;
}

void TrainWorkspace::Parts::askPicture() {
  if (!model.live.shown()) return model.status.say(tr("There is no image yet."));
  const bool wasFrozen = model.live.isFrozen();
  model.live.setFrozen(true);  // The image that the user saw, whatever the dialog takes.
  const QString file = askFile(tr("Save the image"), ".png");
  if (!file.isEmpty()) savePicture(file.toStdString());
  // With measurements the image stays frozen, since they belong to it.
  if (!wasFrozen && input_->callipers().done().empty()) model.live.setFrozen(false);
}

void TrainWorkspace::Parts::askScreen() {
  if (!model.live.shown()) return model.status.say(tr("There is no image yet."));
  // As it was when it was asked for, whatever the dialog takes.
  const QImage screen = pictures_->grab().toImage();
  const QString file = askFile(tr("Save what the screen shows of the image"), "-screen.png");
  if (!file.isEmpty()) startWriting([screen] { return screen; }, file.toStdString());
}

void TrainWorkspace::Parts::askClip() {
  model.live.setFrozen(true);
  const QString folder = QFileDialog::getExistingDirectory(
      &workspace_, tr("Save the clip: a new folder of numbered PNG images, made in"), exportFolder);
  if (folder.isEmpty() || !model.patientCase.patient()) return;
  exportFolder = folder;
  const QString name = exportName(QString::fromStdString(model.patientCase.patient()->manifest.title));
  saveClip(QDir(folder).filePath(name).toStdString());
}

}  // namespace insonate::train
