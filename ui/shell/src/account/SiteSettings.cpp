#include "SiteSettings.h"

#include "PrivateJson.h"

#include <insonate/site/HttpLink.h>
#include <insonate/ui/StoreAddress.h>

#include <QDir>
#include <QFileInfo>
#include <QJsonObject>
#include <QSettings>
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
  const QJsonObject json = readPrivateJson(fileOf(database).toStdString());
  settings.token = json[kSiteToken].toString().toStdString();
  settings.authorityFile = json[kAuthority].toString();
  return settings;
}

Result<void> writeSiteSettings(const QString& database, const SiteSettings& settings) {
  const fs::path file = fileOf(database).toStdString();
  if (settings.isHttp()) {
    QDir().mkpath(QFileInfo(database).absolutePath());
    auto written = writePrivateJson(
        file, {{kSiteToken, QString::fromStdString(settings.token)}, {kAuthority, settings.authorityFile}});
    if (!written) return written;
  } else {
    std::error_code ignored;
    fs::remove(file, ignored);
  }
  QSettings().setValue(kServer, settings.address);
  return {};
}

Result<SiteLink> siteLinkOf(const SiteSettings& settings) {
  return httpLink({.url = settings.address.toStdString(),
                   .token = settings.token,
                   .authority = settings.authorityFile.toStdString()});
}

Result<SiteUpload> siteUploadOf(const CurriculumStore& here, const SiteSettings& settings,
                                const StoreServices& services) {
  if (settings.isHttp()) {
    auto link = siteLinkOf(settings);
    return link ? Result<SiteUpload>(SiteUpload(here, std::move(*link))) : tl::unexpected(link.error());
  }
  // An earlier version of the program may have stored such an address.
  if (const QString refused = refusalOfStore(settings.address); !refused.isEmpty()) return fail(refused.toStdString());
  const auto server = CurriculumStore::open(settings.address.toStdString(), services);
  return server ? Result<SiteUpload>(SiteUpload(here, *server)) : tl::unexpected(server.error());
}

}  // namespace insonate::ui
