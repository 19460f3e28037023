#include "LearningRecords.h"

#include <QEventLoop>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QTimer>
#include <QUrl>
#include <algorithm>
#include <functional>
#include <memory>

namespace insonate::cli {
namespace {

constexpr std::size_t kAtOnce = 50;
constexpr int kPatience_ms = 30'000, kLook_ms = 100;

Result<QUrl> statementsAt(const LearningRecords& records) {
  QUrl url(QString::fromStdString(records.endpoint), QUrl::StrictMode);
  const bool here = url.host() == QLatin1String("localhost") || url.host() == QLatin1String("127.0.0.1");
  const bool safe = url.scheme() == QLatin1String("https") || (here && url.scheme() == QLatin1String("http"));
  if (!url.isValid() || url.host().isEmpty() || !safe || !url.userInfo().isEmpty() || url.hasQuery())
    return fail("'" + records.endpoint +
                "' is not an address of a learning record store. The address begins with https:// and contains no name "
                "and no password, for example https://lrs.example.org/xapi");
  QString path = url.path();
  while (path.endsWith(QLatin1Char('/'))) path.chop(1);
  url.setPath(path + QStringLiteral("/statements"));
  return url;
}

QNetworkRequest requestTo(const QUrl& url, const LearningRecords& records) {
  QNetworkRequest request(url);
  request.setHeader(QNetworkRequest::ContentTypeHeader, QStringLiteral("application/json"));
  request.setRawHeader("X-Experience-API-Version", "1.0.3");
  request.setRawHeader("Authorization",
                       "Basic " + QByteArray::fromStdString(records.user + ":" + records.password).toBase64());
  // A password is not handed on to where someone points.
  request.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
  request.setTransferTimeout(kPatience_ms);
  return request;
}

std::string refusalOf(QNetworkReply& reply, const std::string& endpoint) {
  const int status = reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
  const std::string said = reply.readAll().left(300).simplified().toStdString();
  if (status == 0) return endpoint + " cannot be reached: " + reply.errorString().toStdString() + ".";
  if (status == 401 || status == 403) return endpoint + " does not accept this name and password.";
  if (status == 409)
    return endpoint +
           " has other statements with the same ids; attempts were sent to it by another rule or site before. " + said;
  return endpoint + " did not accept the statements (HTTP " + std::to_string(status) + "). " + said;
}

std::string arrayOf(std::span<const std::string> statements) {
  std::string text = "[";
  for (const std::string& statement : statements) text += (text.size() > 1 ? "," : "") + statement;
  return text + "]";
}

/// Waits for the answer, and gives up where the user does.
Result<void> post(QNetworkAccessManager& network, const QNetworkRequest& request, const std::string& body,
                  const std::string& endpoint, const std::function<bool()>& goOn) {
  const std::unique_ptr<QNetworkReply> reply(network.post(request, QByteArray::fromStdString(body)));
  QEventLoop loop;
  QTimer looking;
  bool cancelled = false;
  QObject::connect(reply.get(), &QNetworkReply::finished, &loop, &QEventLoop::quit);
  QObject::connect(&looking, &QTimer::timeout, &loop, [&] {
    if (goOn()) return;
    cancelled = true;
    reply->abort();
  });
  looking.start(kLook_ms);
  if (!reply->isFinished()) loop.exec();
  if (cancelled) return fail(std::string(kCancelled));
  const int status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
  if (status == 200 || status == 204) return {};
  return fail(refusalOf(*reply, endpoint));
}

}  // namespace

Result<void> sendStatements(const LearningRecords& records, std::span<const std::string> statements,
                            const Progress& progress) {
  const auto url = statementsAt(records);
  if (!url) return tl::unexpected(url.error());
  QNetworkAccessManager network;
  const QNetworkRequest request = requestTo(*url, records);
  for (std::size_t sent = 0; sent < statements.size(); sent += kAtOnce) {
    const auto goOn = [&] { return report(progress, "sending statements", double(sent) / double(statements.size())); };
    const auto batch = statements.subspan(sent, std::min(kAtOnce, statements.size() - sent));
    auto done = post(network, request, arrayOf(batch), records.endpoint, goOn);
    if (done) continue;
    if (sent > 0 && done.error().message != kCancelled)
      done.error().message +=
          " " + std::to_string(sent) +
          " statements were sent before this. Send the file again; the store keeps no statement twice.";
    return done;
  }
  return {};
}

}  // namespace insonate::cli
