#include "PictureExport.h"

#include "ScaledPicture.h"

#include <insonate/core/AtomicFile.h>

#include <QDateTime>
#include <QFile>
#include <utility>

namespace insonate::train {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with its contents, unless it is kept under another name.
class FolderInWork {
 public:
  explicit FolderInWork(fs::path path) : path_(std::move(path)) {}
  ~FolderInWork() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  FolderInWork(const FolderInWork&) = delete;
  FolderInWork& operator=(const FolderInWork&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Result<void> write(const QImage& picture, const fs::path& file) {
  return writeAtomically(file, [&](const fs::path& beside) -> Result<void> {
    // QImage does not report that the end of a file, which is in a buffer, was not written.
    QFile out(QString::fromStdString(beside.string()));
    if (out.open(QIODevice::WriteOnly) && picture.save(&out, "PNG") && out.flush()) return {};
    return fail("Could not write " + file.string() +
                ": the disk is full or the folder cannot be written. Free space or choose another folder.");
  });
}

}  // namespace

QString exportName(const QString& caseTitle) {
  QString name;
  for (const QChar letter : caseTitle) name += letter.isLetterOrNumber() ? letter.toLower() : QChar('-');
  while (name.contains("--")) name.replace("--", "-");
  return name + QDateTime::currentDateTime().toString("-yyyyMMdd-HHmmss");
}

ImageWriter::ImageWriter(std::function<QImage()> make, fs::path file, std::function<void(Result<void>)> ended) {
  thread_ = std::thread([this, make = std::move(make), file = std::move(file), ended = std::move(ended)] {
    const Result<void> result = write(make(), file);
    QMetaObject::invokeMethod(
        this, [ended, result] { ended(result); }, Qt::QueuedConnection);
  });
}

ImageWriter::~ImageWriter() {
  thread_.join();
}

Result<int> writeImages(const std::vector<std::shared_ptr<const LiveFrame>>& frames,
                        std::span<const views::Caliper> calipers, const fs::path& folder, const Progress& progress) {
  std::error_code error;
  if (fs::exists(folder, error))
    return fail("A file or folder with this name already exists: " + folder.string() + "; choose another name.");
  const FolderInWork beside(folder.string() + ".part");
  fs::remove_all(beside.path(), error);
  fs::create_directories(beside.path(), error);
  if (error)
    return fail("The folder " + folder.string() + " cannot be made: " + error.message() + ". Choose another place.");
  int written = 0;
  for (const auto& frame : frames) {
    if (!report(progress, "writing images", double(written) / double(frames.size())))
      return fail(std::string(kCancelled));
    const QString name = QStringLiteral("picture-%1.png").arg(written + 1, 4, 10, QChar('0'));
    if (auto ok = write(scaledPicture(*frame, calipers), beside.path() / name.toStdString()); !ok)
      return tl::unexpected(ok.error());
    ++written;
  }
  fs::rename(beside.path(), folder, error);
  if (error) return fail("The clip cannot be written to " + folder.string() + ": " + error.message() + ".");
  return written;
}

}  // namespace insonate::train
