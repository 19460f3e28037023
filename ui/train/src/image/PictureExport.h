#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/views/Caliper.h>

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

/// Returns a file name made of the case's title, date and time, without extension, which is valid on every file system.
QString exportName(const QString& caseTitle);

/// Writes an image as PNG on a background thread, on which `make` is also called. After that, `ended` is called on the
/// window's thread, unless the writer was deleted before. The destructor waits for the file. The file is written
/// completely or not at all.
class ImageWriter : public QObject {
 public:
  ImageWriter(std::function<QImage()> make, std::filesystem::path file, std::function<void(Result<void>)> ended);
  ~ImageWriter() override;

 private:
  std::thread thread_;
};

/// Writes images with their scale and measurements as image-0001.png, image-0002.png, ... into a new folder and returns
/// their number. The folder appears when all images are written; after a failure or cancellation, nothing is left.
/// Fails if the folder exists.
Result<int> writeImages(const std::vector<std::shared_ptr<const LiveFrame>>& frames,
                        std::span<const views::Caliper> calipers, const std::filesystem::path& folder,
                        const Progress& progress);

}  // namespace insonate::train
