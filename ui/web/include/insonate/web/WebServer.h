#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/web/OpenIdOptions.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace insonate::web {

enum class LogLevel { Info, Error };
/// Function that receives each event to be logged as a JSON object, such as
/// {"event":"request","route":"/me","status":200}. The object contains no names of people, no addresses and no queries.
/// Called on several threads.
using Log = std::function<void(LogLevel, const std::string& object)>;

/// Address of a server, and how its connections are protected.
struct WebOptions {
  /// Address of this computer at which the server listens, or a name of this computer, which is looked up at the start
  /// (IPv4 before IPv6). "0.0.0.0": all IPv4 addresses; "::": all addresses.
  std::string address = "127.0.0.1";
  int port = 8443;  ///< port, 1 to 65535; 0: any free port
  /// Files (PEM) with the server's certificate chain and its private key. Both empty: HTTP without encryption, which is
  /// allowed at a loopback address only.
  std::filesystem::path certificate{}, key{};
  /// true: a proxy on this computer receives HTTPS and passes requests on by HTTP; cookies are then for HTTPS only. The
  /// proxy must pass the header Host on as the browser sent it.
  bool behindProxy = false;
  /// Addresses of proxies whose header X-Forwarded-For is trusted to name the client. Empty behind a proxy: clients are
  /// unknown, and sign-ins are limited by name only.
  std::vector<std::string> proxies{};
  /// Secret by which programs on other computers may read /health and /metrics: 16 characters or more. Empty: only
  /// programs on this computer may.
  std::string monitoringToken{};
  /// Folder for the videos of attempts that users requested; empty: "videos" beside the folder of recordings. Several
  /// servers with one database need a common folder.
  std::filesystem::path videos{};
  double videoSpace_GB = 20;  ///< above this size, the videos that were watched longest ago are removed
  /// Folder with the folders of cases. Workstations download the published cases of this folder, and videos of attempts
  /// on these cases are made from it. Empty: built-in cases only. Several servers with one database need a common
  /// folder.
  std::filesystem::path cases{};
  /// Maximum size of the recordings that one workstation may send in 24 hours. Further recordings stay on the
  /// workstation and are sent later.
  double recordingsPerDay_GB = 20;
  /// File outside of the database to which the end of the audit log is appended each minute (AuditAnchors); empty:
  /// none.
  std::filesystem::path auditAnchors{};
  OpenIdOptions openId{};  ///< identity provider of the hospital, by which users may sign in
  Log log{};               ///< receives events to be logged; empty: nothing is logged
};

/// Fails with a sentence if the options contradict each other, would send passwords without encryption over a network,
/// or name a certificate that cannot be used. Opens no port.
Result<void> checkOptions(const WebOptions& options);

/// Serves the pages of a curriculum database to browsers: trainees see their levels and attempts, instructors their
/// classes, administrators the audit log. Each request has the permissions of its signed-in user, as in all programs
/// that open the database. The server owns its threads, which end when the object is destroyed.
class WebServer {
 public:
  /// Starts a server. Fails with a sentence if the address is in use, or for a reason of checkOptions().
  static Result<WebServer> start(const CurriculumStore& store, const WebOptions& options);
  ~WebServer();
  WebServer(WebServer&&) noexcept;
  WebServer& operator=(WebServer&&) noexcept;

  /// Returns the address for a browser: "http://127.0.0.1:8443/", "http://[::1]:8443/".
  std::string url() const;

 private:
  struct Impl;
  explicit WebServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate::web
