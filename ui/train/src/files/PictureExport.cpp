#include "PictureExport.h"

#include <insonate/core/Progress.h>
#include <insonate/simulator/PictureFiles.h>

#include <QDateTime>

namespace insonate::train {

QString exportName(const QString& caseTitle) {
  QString name;
  for (const QChar letter : caseTitle) name += letter.isLetterOrNumber() ? letter.toLower() : QChar('-');
  while (name.contains("--")) name.replace("--", "-");
  return name + QDateTime::currentDateTime().toString("-yyyyMMdd-HHmmss");
}

ClipWriter::ClipWriter(Frames frames, std::filesystem::path folder, std::function<void(double)> progress,
                       std::function<void(Result<int>)> ended)
    : frames_(std::move(frames)), folder_(std::move(folder)), progress_(std::move(progress)) {
  thread_ = std::thread([this, ended = std::move(ended)] {
    const Result<int> result = write();
    QMetaObject::invokeMethod(
        this, [ended, result] { ended(result); }, Qt::QueuedConnection);
  });
}

ClipWriter::~ClipWriter() {
  cancelled_ = true;
  thread_.join();
}

Result<int> ClipWriter::write() {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error) return fail("The folder " + folder_.string() + " cannot be made: " + error.message() + ".");
  int written = 0;
  for (const auto& frame : frames_) {
    if (cancelled_) return fail(std::string(kCancelled));
    const QString name = QStringLiteral("picture-%1.png").arg(written + 1, 4, 10, QChar('0'));
    if (auto ok = writePng(frame->image, folder_ / name.toStdString()); !ok) return tl::unexpected(ok.error());
    ++written;
    const double share = double(written) / double(frames_.size());
    QMetaObject::invokeMethod(
        this, [this, share] { progress_(share); }, Qt::QueuedConnection);
  }
  return written;
}

}  // namespace insonate::train
