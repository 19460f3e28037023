#include <insonate/ui/StoreAddress.h>

#include <QCoreApplication>

namespace insonate::ui {

bool isPostgresAddress(const QString& address) {
  return address.startsWith(QLatin1String("postgresql://")) || address.startsWith(QLatin1String("postgres://"));
}

QString refusalOfStore(const QString& address) {
  if (!isPostgresAddress(address)) return {};
  return QCoreApplication::translate(
      "StoreAddress",
      "The window does not open a PostgreSQL database, since everyone who knows its password can change the data of "
      "all "
      "people. Ask the administrator of your site for the address of its server (https://...) and the token of this "
      "computer, and enter both under Hospital server. Administrators use the server's pages or insonate-cli.");
}

}  // namespace insonate::ui
