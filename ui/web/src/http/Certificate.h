#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace insonate::web {

/// Certificate chain and private key of a server, as PEM.
struct Certificate {
  std::string chain{}, key{};
  std::int64_t validUntil_s = 0;  ///< end of the certificate's validity, since 1970, UTC
};

/// Reads the files of a certificate chain and its private key. Fails with a sentence for each fault: a file that cannot
/// be read or is no PEM, a key with a passphrase, a key of another certificate, a certificate that is not valid at
/// `now_s` (since 1970, UTC).
Result<Certificate> readCertificate(const std::filesystem::path& chain, const std::filesystem::path& key,
                                    std::int64_t now_s);

}  // namespace insonate::web
