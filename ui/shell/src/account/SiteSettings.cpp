#include "SiteSettings.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/site/HttpLink.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <fstream>
#include <system_error>

namespace insonate::ui {
namespace {

namespace fs = std::filesystem;

const QString kServer = QStringLiteral("account/server");
const QString kSiteToken = QStringLiteral("token"), kAuthority = QStringLiteral("authority");

QString fileOf(const QString& database) {
  return database + QStringLiteral(".site");
}

}  // namespace

bool SiteSettings::isHttp() const {
  return isHttpAddress(address.toStdString());
}

SiteSettings readSiteSettings(const QString& database) {
  SiteSettings settings{.address = QSettings().value(kServer).toString()};
  if (!settings.isHttp()) return settings;
  QFile stream(fileOf(database));
  if (!stream.open(QIODevice::ReadOnly)) return settings;
  const QJsonObject json = QJsonDocument::fromJson(stream.readAll()).object();
  settings.token = json[kSiteToken].toString().toStdString();
  settings.authorityFile = json[kAuthority].toString();
  return settings;
}

Result<void> writeSiteSettings(const QString& database, const SiteSettings& settings) {
  const fs::path file = fileOf(database).toStdString();
  if (settings.isHttp()) {
    QDir().mkpath(QFileInfo(database).absolutePath());
    const QByteArray bytes = QJsonDocument(QJsonObject{{kSiteToken, QString::fromStdString(settings.token)},
                                                       {kAuthority, settings.authorityFile}})
                                 .toJson();
    auto written = writeAtomically(file, [&bytes](const fs::path& beside) -> Result<void> {
      std::ofstream stream(beside, std::ios::binary);
      std::error_code error;
      fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write, error);
      if (error || !stream.write(bytes.data(), bytes.size()).flush())
        return fail("Could not write " + beside.string() + ".");
      return {};
    });
    if (!written) return written;
  } else {
    std::error_code ignored;
    fs::remove(file, ignored);
  }
  QSettings().setValue(kServer, settings.address);
  return {};
}

Result<SiteUpload> siteUploadOf(const CurriculumStore& here, const SiteSettings& settings,
                                const StoreServices& services) {
  if (settings.isHttp()) {
    auto link = httpLink({.url = settings.address.toStdString(),
                          .token = settings.token,
                          .authority = settings.authorityFile.toStdString()});
    return link ? Result<SiteUpload>(SiteUpload(here, std::move(*link))) : tl::unexpected(link.error());
  }
  const auto server = CurriculumStore::open(settings.address.toStdString(), services);
  return server ? Result<SiteUpload>(SiteUpload(here, *server)) : tl::unexpected(server.error());
}

}  // namespace insonate::ui
