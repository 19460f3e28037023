#pragma once

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SiteUpload.h>

#include <QString>
#include <optional>
#include <string>

namespace insonate::ui {

/// The server of the site to which a database of this computer belongs.
struct SiteSettings {
  QString address{};        ///< https://HOST of insonate-server, or a database file; empty: no server
  std::string token{};      ///< token of this computer; used only with an https address
  QString authorityFile{};  ///< file (PEM) with the certificate of the authority that signed the server's certificate;
                            ///< empty: the authorities that the system trusts

  bool isHttp() const;
};

/// Reads the settings: the address from the user's settings, the token from a file beside the database.
SiteSettings readSiteSettings(const QString& database);
/// Writes the settings. Only the owner of the file with the token can read the file. Fails if the settings cannot be
/// written.
Result<void> writeSiteSettings(const QString& database, const SiteSettings& settings);

/// Makes a connection to a server with an https address. Nothing is sent yet.
Result<SiteLink> siteLinkOf(const SiteSettings& settings);
/// Makes the exchange with the server. If the address is that of a database file, this opens the file. Fails if the
/// address is that of a PostgreSQL database (refusalOfStore()).
Result<SiteUpload> siteUploadOf(const CurriculumStore& here, const SiteSettings& settings,
                                const StoreServices& services);

}  // namespace insonate::ui
