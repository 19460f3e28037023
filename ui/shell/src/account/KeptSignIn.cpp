#include "KeptSignIn.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/PeopleStore.h>

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <fstream>
#include <system_error>

namespace insonate::ui {
namespace {

namespace fs = std::filesystem;

const QString kToken = QStringLiteral("token"), kPassword = QStringLiteral("password");

}  // namespace

KeptSignIn readKeptSignIn(const fs::path& file) {
  QFile stream(QString::fromStdString(file.string()));
  if (!stream.open(QIODevice::ReadOnly)) return {};
  const QJsonObject json = QJsonDocument::fromJson(stream.readAll()).object();
  KeptSignIn kept{json[kToken].toString().toStdString(), json[kPassword].toString().toStdString()};
  return kept.token.empty() ? KeptSignIn() : kept;
}

Result<void> keepSignedIn(const fs::path& file, const SignedIn& by, const std::string& generatedPassword) {
  const auto token = PeopleStore(by).staySignedIn();
  if (!token) return tl::unexpected(token.error());
  QJsonObject json{{kToken, QString::fromStdString(*token)}};
  if (!generatedPassword.empty()) json[kPassword] = QString::fromStdString(generatedPassword);
  const QByteArray text = QJsonDocument(json).toJson();
  return writeAtomically(file, [&text](const fs::path& beside) -> Result<void> {
    std::ofstream stream(beside, std::ios::binary);
    std::error_code error;
    fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write, error);
    if (error || !stream.write(text.data(), text.size()).flush())
      return fail("Could not write " + beside.string() + ".");
    return {};
  });
}

bool removeKeptSignIn(const fs::path& file) {
  std::error_code error;
  return fs::remove(file, error);
}

}  // namespace insonate::ui
