#include "openings/TestCodes.h"

#include "signin/SignInPages.h"

#include <QMessageAuthenticationCode>

namespace insonate::web {
namespace {

/// The name of the cookie. A later session of another user has other names.
std::string codeCookie(const Visit& visit, const std::string& opening) {
  return "code-" + QMessageAuthenticationCode::hash(QByteArray::fromStdString(opening),
                                                    QByteArray::fromStdString(visit.secret), QCryptographicHash::Sha256)
                       .toHex()
                       .left(32)
                       .toStdString();
}

}  // namespace

std::pair<std::string, std::string> codeHeader(const Visit& visit, const std::string& page, const std::string& opening,
                                               const std::string& code) {
  // A test is open for two weeks at most, or until it is closed.
  std::string value = codeCookie(visit, opening) + "=" + encoded(code) + "; Path=" + page +
                      "; Max-Age=1209600; HttpOnly; SameSite=Strict";
  if (hasHttps(visit.options)) value += "; Secure";
  return {"Set-Cookie", value};
}

std::string codeOf(const Visit& visit, const std::string& opening) {
  return decoded(valueOf(visit.request.cookies, codeCookie(visit, opening)), false);
}

}  // namespace insonate::web
