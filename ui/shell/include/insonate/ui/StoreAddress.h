#pragma once

#include <QString>

namespace insonate::ui {

/// Tells whether an address is that of a PostgreSQL database.
bool isPostgresAddress(const QString& address);

/// Returns a sentence that says why the window does not open this address, and what to do; empty if the window may open
/// it. The window refuses PostgreSQL databases, since everyone who knows the password of such a database can change the
/// data of all people.
QString refusalOfStore(const QString& address);

}  // namespace insonate::ui
