#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Address of a site's server (insonate-server), and the workstation's token for it.
struct SiteAddress {
  std::string url{};    ///< address of the server: "https://training.example.org"; http:// is allowed at a loopback
                        ///< address only
  std::string token{};  ///< token that `insonate-cli curriculum workstations add` has issued
  /// File (PEM) with the certificate of the authority that signed the server's certificate; empty: the authorities that
  /// the system trusts.
  std::filesystem::path authority{};
};

/// Tells whether an address is that of a server reached by HTTP or HTTPS.
bool isHttpAddress(const std::string& address);

/// Makes a connection to a server by HTTPS. Nothing is sent yet. Fails if the address would send the token without
/// encryption over a network. A request is given up after ten minutes, or if nothing is transferred for 30 s.
Result<SiteLink> httpLink(const SiteAddress& address);

}  // namespace insonate
