#include "openid/ProviderAddress.h"

#include "http/Messages.h"
#include "http/SocketAddress.h"

#include <QUrl>
#include <fstream>

namespace insonate::web {
namespace {

QUrl strictUrl(const std::string& url) {
  return QUrl(QString::fromStdString(url), QUrl::StrictMode);
}

bool isLoopbackHost(const std::string& host) {
  return host == "localhost" || isLoopbackAddress(host);
}

bool isReadable(const std::filesystem::path& file) {
  return std::filesystem::is_regular_file(file) && std::ifstream(file).good();
}

}  // namespace

bool isOnLoopback(const std::string& url) {
  return isLoopbackHost(strictUrl(url).host().toStdString());
}

bool isProtected(const std::string& url) {
  const QUrl parsed = strictUrl(url);
  if (!parsed.isValid() || parsed.host().isEmpty() || !parsed.userInfo().isEmpty()) return false;
  return url.starts_with("https://") || (url.starts_with("http://") && isOnLoopback(url));
}

std::string withQuery(const std::string& url, const std::vector<std::pair<std::string, std::string>>& values) {
  std::string whole = url;
  for (const auto& [name, value] : values)
    whole += (whole.find('?') == std::string::npos ? "?" : "&") + encoded(name) + "=" + encoded(value);
  return whole;
}

Result<void> checkOpenIdOptions(const OpenIdOptions& options) {
  const auto& [issuer, clientId, secret, name, authority] = options;
  if (issuer.empty() && clientId.empty() && secret.empty() && name.empty() && authority.empty()) return {};
  if (issuer.empty() || clientId.empty() || secret.empty() || name.empty())
    return fail(
        "Sign-in by OpenID Connect needs openid-issuer, openid-client, openid-secret-file and openid-name. Set all of "
        "them, or none.");
  if (!isProtected(issuer))
    return fail("The issuer " + issuer +
                " is not an https:// address, so that others could read or change what it sends. Use https://; only "
                "an issuer at a loopback address (127.0.0.1) may be http://.");
  if (issuer.find_first_of("?#") != std::string::npos)
    return fail("The issuer " + issuer +
                " has a query or a fragment. Use the address that the provider states as issuer.");
  if (!authority.empty() && !isReadable(authority))
    return fail("The authority's certificate " + authority.string() + " cannot be read. Name a file in PEM.");
  return {};
}

}  // namespace insonate::web
