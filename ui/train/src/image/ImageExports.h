#pragma once

#include "ClipExport.h"
#include "PictureExport.h"

#include <insonate/views/Caliper.h>

#include <QImage>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

class QSettings;

namespace insonate::ui {
class Workspace;
}

namespace insonate::train {

class CaseModel;
class CineBar;
class EqualPanes;
class ImageInput;
class LiveModel;
class StatusLine;

/// Saves images and clips on the user's request, and remembers the folder.
class ImageExports : public QObject {
  Q_OBJECT

 public:
  struct Sources {
    CaseModel& patientCase;
    LiveModel& live;
    StatusLine& status;
    CineBar& cine;
    ImageInput& input;
    EqualPanes& panes;  ///< contains the image and the CT beside it
  };
  ImageExports(const Sources& sources, ui::Workspace& workspace, QObject* parent);

  void saveImage(const std::filesystem::path& file);
  void saveScreen(const std::filesystem::path& file);
  /// Saves the images of the last seconds in the format of the target's ending; see writeClip().
  void saveClip(const std::filesystem::path& target);
  /// Asks the user for a file and saves the image on display.
  void askPicture();

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 private:
  void askScreen();
  void askClip();
  /// Adds the ending of the clip's format to a file without a known ending; empty if that file exists.
  QString withEnding(const QString& file);
  void showSaved(const std::filesystem::path& clip, int images, std::size_t shown);
  QString askFile(const QString& title, const QString& ending);
  void startWriting(std::function<QImage()> make, const std::filesystem::path& file);
  std::vector<views::Caliper> measurements() const;

  Sources sources_;
  ui::Workspace& workspace_;
  QString folder_;                             ///< folder of the last saved image
  ClipFormat clipFormat_ = ClipFormat::Video;  ///< format of the last saved clip
  std::vector<std::unique_ptr<ImageWriter>> writers_;
};

}  // namespace insonate::train
