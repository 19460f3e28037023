#include "http/Certificate.h"

#include <gnutls/abstract.h>
#include <gnutls/x509.h>

#include <QDateTime>
#include <QLocale>
#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

namespace insonate::web {
namespace {

template <auto kFree>
struct Freeing {
  template <class T>
  void operator()(T* object) const {
    kFree(object);
  }
};
using PrivateKey = std::unique_ptr<gnutls_privkey_st, Freeing<gnutls_privkey_deinit>>;
using PublicKey = std::unique_ptr<gnutls_pubkey_st, Freeing<gnutls_pubkey_deinit>>;
using X509 = std::unique_ptr<gnutls_x509_crt_int, Freeing<gnutls_x509_crt_deinit>>;

Result<std::string> readFile(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return fail(file.string() + " is a folder. Name a readable file in PEM.");
  std::ifstream in(file, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in || text.empty()) return fail(file.string() + " cannot be read, or is empty. Name a readable file in PEM.");
  return text;
}

gnutls_datum_t datumOf(std::string& text) {
  return {reinterpret_cast<unsigned char*>(text.data()), static_cast<unsigned>(text.size())};
}

/// The first certificate of the chain, which is the server's own; null if there is none.
X509 firstOf(std::string& chain) {
  const gnutls_datum_t text = datumOf(chain);
  gnutls_x509_crt_t* list = nullptr;
  unsigned count = 0;
  if (gnutls_x509_crt_list_import2(&list, &count, &text, GNUTLS_X509_FMT_PEM, 0) < 0 || count == 0) return nullptr;
  for (unsigned i = 1; i < count; ++i) gnutls_x509_crt_deinit(list[i]);
  X509 first(list[0]);
  gnutls_free(list);
  return first;
}

Result<PrivateKey> privateKeyOf(std::string& text, const std::filesystem::path& file) {
  gnutls_privkey_t raw = nullptr;
  gnutls_privkey_init(&raw);
  PrivateKey key(raw);
  const gnutls_datum_t data = datumOf(text);
  const int code = gnutls_privkey_import_x509_raw(raw, &data, GNUTLS_X509_FMT_PEM, nullptr, 0);
  if (code >= 0) return key;
  if (code == GNUTLS_E_DECRYPTION_FAILED || text.find("ENCRYPTED") != std::string::npos)
    return fail("The private key " + file.string() +
                " has a passphrase, which the server cannot ask for. Remove it: openssl pkey -in KEY -out NEWKEY");
  return fail(file.string() + " contains no private key in PEM (text that begins with -----BEGIN PRIVATE KEY-----).");
}

std::array<unsigned char, 32> idOf(const PublicKey& key) {
  std::array<unsigned char, 32> id{};
  std::size_t size = id.size();
  gnutls_pubkey_get_key_id(key.get(), GNUTLS_KEYID_USE_SHA256, id.data(), &size);
  return id;
}

bool belongTogether(const X509& certificate, const PrivateKey& key) {
  gnutls_pubkey_t own = nullptr, certified = nullptr;
  gnutls_pubkey_init(&own);
  gnutls_pubkey_init(&certified);
  const PublicKey ofKey(own), ofCertificate(certified);
  return gnutls_pubkey_import_privkey(own, key.get(), 0, 0) >= 0 &&
         gnutls_pubkey_import_x509(certified, certificate.get(), 0) >= 0 && idOf(ofKey) == idOf(ofCertificate);
}

std::string dayOf(std::int64_t time_s) {
  return QLocale(QLocale::English)
      .toString(QDateTime::fromSecsSinceEpoch(time_s, Qt::UTC).date(), QStringLiteral("d MMM yyyy"))
      .toStdString();
}

}  // namespace

Result<Certificate> readCertificate(const std::filesystem::path& chain, const std::filesystem::path& key,
                                    std::int64_t now_s) {
  auto chainText = readFile(chain);
  if (!chainText) return tl::unexpected(chainText.error());
  auto keyText = readFile(key);
  if (!keyText) return tl::unexpected(keyText.error());
  const X509 own = firstOf(*chainText);
  if (!own)
    return fail(chain.string() +
                " contains no certificate in PEM (text that begins with -----BEGIN CERTIFICATE-----).");
  const auto ownKey = privateKeyOf(*keyText, key);
  if (!ownKey) return tl::unexpected(ownKey.error());
  if (!belongTogether(own, *ownKey))
    return fail(
        "The private key " + key.string() + " does not belong to the certificate " + chain.string() +
        ". Name the key for which the certificate was made; the server's own certificate is first in its file.");
  const std::int64_t from_s = gnutls_x509_crt_get_activation_time(own.get());
  const std::int64_t until_s = gnutls_x509_crt_get_expiration_time(own.get());
  if (now_s > until_s)
    return fail("The certificate " + chain.string() + " expired on " + dayOf(until_s) + ". Renew it.");
  if (now_s < from_s)
    return fail("The certificate " + chain.string() + " is valid only from " + dayOf(from_s) +
                ". Check the clock of this computer.");
  return Certificate{std::move(*chainText), std::move(*keyText), until_s};
}

}  // namespace insonate::web
