#include "Site.h"
#include "audit/AnchorKeeper.h"
#include "http/Certificate.h"
#include "http/HttpServer.h"
#include "http/SocketAddress.h"
#include "openid/ProviderAddress.h"
#include "retention/DataDeletion.h"
#include "site/Verifier.h"
#include "video/VideoMaker.h"

#include <insonate/web/WebServer.h>

#include <chrono>

namespace insonate::web {

Result<void> checkOptions(const WebOptions& options) {
  if (options.certificate.empty() != options.key.empty())
    return fail("A certificate and its private key belong together. Give both of them, or neither.");
  const auto address = resolvedAddress(options.address);
  if (!address) return tl::unexpected(address.error());
  if (options.certificate.empty() && !isLoopbackAddress(*address))
    return fail(
        "Without a certificate, passwords would cross the network unencrypted. Give --certificate and --key, or listen "
        "at 127.0.0.1 behind a proxy that receives HTTPS.");
  for (const std::string& proxy : options.proxies)
    if (!isAddress(proxy))
      return fail("'" + proxy + "' is not an IP address; --proxy takes the address from which the proxy connects.");
  constexpr std::size_t kShortestToken = 16;
  if (!options.monitoringToken.empty() && options.monitoringToken.size() < kShortestToken)
    return fail("The token for monitoring is shorter than 16 characters. Make one with: openssl rand -hex 32");
  if (auto ok = checkOpenIdOptions(options.openId); !ok) return ok;
  if (options.certificate.empty()) return {};
  using namespace std::chrono;
  const std::int64_t now_s = duration_cast<seconds>(system_clock::now().time_since_epoch()).count();
  if (const auto read = readCertificate(options.certificate, options.key, now_s); !read)
    return tl::unexpected(read.error());
  return {};
}

struct WebServer::Impl {
  Impl(const CurriculumStore& store, WebOptions serverOptions) : options(serverOptions), site(store, serverOptions) {}
  ~Impl() { site.endStreams(); }

  WebOptions options;
  Site site;
  std::unique_ptr<HttpServer> http;
  std::unique_ptr<Verifier> verifier;
  std::unique_ptr<DataDeletion> dataDeletion;
  std::unique_ptr<VideoMaker> videoMaker;
  std::unique_ptr<AnchorKeeper> anchorKeeper;
};

WebServer::WebServer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
WebServer::~WebServer() = default;
WebServer::WebServer(WebServer&&) noexcept = default;
WebServer& WebServer::operator=(WebServer&&) noexcept = default;

Result<WebServer> WebServer::start(const CurriculumStore& store, const WebOptions& options) {
  WebOptions used = options;
  // A name is looked up once, so that the address is the one that was checked.
  auto address = resolvedAddress(options.address);
  if (!address) return tl::unexpected(address.error());
  used.address = std::move(*address);
  if (auto ok = checkOptions(used); !ok) return tl::unexpected(ok.error());
  if (used.videos.empty() && !store.recordings().empty()) used.videos = store.recordings().parent_path() / "videos";
  if (!used.videos.empty()) used.videos = std::filesystem::absolute(used.videos);
  AuditAnchors anchors(store, used.auditAnchors);
  if (!used.auditAnchors.empty())
    if (auto written = anchors.append(); !written) return tl::unexpected(written.error());
  auto impl = std::make_unique<Impl>(store, used);
  auto http = HttpServer::start(
      used, [site = &impl->site](const Request& request) { return site->answer(request); }, {},
      [site = &impl->site](int status) { site->noteRefused(status); },
      [site = &impl->site](const Request& request) { return site->admit(request); });
  if (!http) return tl::unexpected(http.error());
  impl->http = std::move(*http);
  impl->verifier = std::make_unique<Verifier>(store, options.cases, options.log);
  impl->dataDeletion = std::make_unique<DataDeletion>(store, used);
  if (!used.videos.empty()) impl->videoMaker = std::make_unique<VideoMaker>(store, used);
  if (!used.auditAnchors.empty()) impl->anchorKeeper = std::make_unique<AnchorKeeper>(std::move(anchors), options.log);
  return WebServer(std::move(impl));
}

std::string WebServer::url() const {
  return (impl_->options.certificate.empty() ? "http://" : "https://") +
         withPort(impl_->options.address, impl_->http->port()) + "/";
}

}  // namespace insonate::web
