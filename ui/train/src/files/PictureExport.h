#pragma once

#include <insonate/core/Result.h>
#include <insonate/simulator/LiveImaging.h>

#include <QObject>
#include <QString>
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <thread>
#include <vector>

namespace insonate::train {

/// A file name for what is on display: case, date and time; without extension, fit for every file system.
QString exportName(const QString& caseTitle);

/// Writes pictures as picture-0001.png, picture-0002.png, ... into a folder, which it makes, on a thread of its own.
/// `ended` is called on the window's thread, with an error or the number of pictures. The destructor cancels.
class ClipWriter : public QObject {
 public:
  using Frames = std::vector<std::shared_ptr<const LiveFrame>>;
  ClipWriter(Frames frames, std::filesystem::path folder, std::function<void(double share)> progress,
             std::function<void(Result<int>)> ended);
  ~ClipWriter() override;

  void cancel() { cancelled_ = true; }

 private:
  Result<int> write();

  Frames frames_;
  std::filesystem::path folder_;
  std::function<void(double)> progress_;
  std::atomic<bool> cancelled_{false};
  std::thread thread_;
};

}  // namespace insonate::train
