#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/views/Calliper.h>

#include <QImage>
#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <thread>
#include <vector>

namespace insonate::train {

/// File name for the image on display: case, date and time; without extension, valid on every file system.
QString exportName(const QString& caseTitle);

/// Writes an image as PNG on a thread of its own, where `make` is called, too. `ended` is called on the window's
/// thread, unless the writer has gone before; its destructor waits for the file, which is there as a whole or not at
/// all.
class PictureWriter : public QObject {
 public:
  PictureWriter(std::function<QImage()> make, std::filesystem::path file, std::function<void(Result<void>)> ended);
  ~PictureWriter() override;

 private:
  std::thread thread_;
};

/// Writes images with their scale and measurements as image-0001.png, image-0002.png, ... into a new folder and
/// returns their number. The folder appears when all of them are written; after a failure or cancellation, nothing is
/// left. Refuses an existing folder.
Result<int> writeClip(const std::vector<std::shared_ptr<const LiveFrame>>& frames,
                      std::span<const views::Calliper> callipers, const std::filesystem::path& folder,
                      const Progress& progress);

}  // namespace insonate::train
