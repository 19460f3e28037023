#include "store/sql/Address.h"

#include <QtCore/QUrl>

namespace insonate::store {
namespace {

bool isUrl(const QString& text) {
  return text.startsWith("postgresql://") || text.startsWith("postgres://");
}

Result<Address> ofServer(const QString& text) {
  const QUrl url(text, QUrl::StrictMode);
  Address address;
  address.isServer = true;
  address.host = url.host();
  address.database = url.path(QUrl::FullyDecoded).mid(1);
  address.user = url.userName(QUrl::FullyDecoded);
  address.password = url.password(QUrl::FullyDecoded);
  address.port = url.port(5432);
  if (!url.isValid() || address.host.isEmpty() || address.database.isEmpty() || address.user.isEmpty())
    return fail(
        "The address of the server does not name a user, a host and a database: write it as "
        "postgresql://USER@HOST:PORT/DATABASE, with the password in PGPASSWORD or ~/.pgpass.");
  return address;
}

}  // namespace

Result<Address> Address::parse(const std::string& text) {
  const QString words = QString::fromStdString(text);
  if (words.trimmed().isEmpty())
    return fail("The address of the curriculum's store is empty; name a file or a server.");
  if (words.contains(QChar('\0'))) return fail("The address of the curriculum's store holds a zero byte; name a file.");
  if (isUrl(words)) return ofServer(words);
  Address address;
  address.file = words;
  return address;
}

std::string Address::place() const {
  if (!isServer) return (copyOf.isEmpty() ? file : copyOf).toStdString();
  return QString("postgresql://%1@%2:%3/%4").arg(user, host).arg(port).arg(database).toStdString();
}

}  // namespace insonate::store
