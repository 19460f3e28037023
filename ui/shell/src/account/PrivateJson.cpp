#include "PrivateJson.h"

#include <insonate/core/AtomicFile.h>

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <fstream>
#include <system_error>

namespace insonate::ui {

namespace fs = std::filesystem;

QJsonObject readPrivateJson(const fs::path& file) {
  QFile stream(QString::fromStdString(file.string()));
  if (!stream.open(QIODevice::ReadOnly)) return {};
  return QJsonDocument::fromJson(stream.readAll()).object();
}

Result<void> writePrivateJson(const fs::path& file, const QJsonObject& json) {
  const QByteArray bytes = QJsonDocument(json).toJson();
  return writeAtomically(file, [&bytes](const fs::path& beside) -> Result<void> {
    std::ofstream stream(beside, std::ios::binary);
    std::error_code error;
    fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write, error);
    if (error || !stream.write(bytes.data(), bytes.size()).flush())
      return fail("Could not write " + beside.string() + ".");
    return {};
  });
}

}  // namespace insonate::ui
