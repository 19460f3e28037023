#include "ServerLog.h"

#include <insonate/curriculum/Curriculum.h>
#include <insonate/teaching/DemoClass.h>
#include <insonate/web/WebServer.h>

#include <CLI/CLI.hpp>

#include <QDir>
#include <QTemporaryDir>
#include <charconv>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>

namespace {

using namespace insonate;

struct Arguments {
  std::string database;
  std::string recordings;
  std::string listen = "127.0.0.1:8443";
  std::string tokenFile;
  std::string openIdSecretFile;
  web::WebOptions options;
  bool demo = false;
};

constexpr const char* kDemoPassword = "made-up password";
constexpr int kDemoTrainees = 12, kDemoAttempts = 20;

Result<void> readListen(Arguments& arguments) {
  const std::size_t colon = arguments.listen.rfind(':');
  const std::string port = colon == std::string::npos ? arguments.listen : arguments.listen.substr(colon + 1);
  if (colon != std::string::npos) {
    std::string& address = arguments.options.address = arguments.listen.substr(0, colon);
    if (address.starts_with('[') && address.ends_with(']'))
      address = address.substr(1, address.size() - 2);
    else if (address.find(':') != std::string::npos)
      return fail("--listen takes an IPv6 address in brackets, such as [::1]:8443, not '" + arguments.listen + "'.");
  }
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), arguments.options.port);
  if (error != std::errc() || end != port.data() + port.size() || arguments.options.port < 0 ||
      arguments.options.port > 65535)
    return fail("--listen takes ADDRESS:PORT, such as 127.0.0.1:8443, not '" + arguments.listen + "'.");
  return {};
}

/// The token is in a file, since all users of a computer can read the command lines of its programs.
Result<void> readToken(Arguments& arguments) {
  if (arguments.tokenFile.empty()) return {};
  std::ifstream in(arguments.tokenFile);
  if (!(in >> arguments.options.monitoringToken))
    return fail(arguments.tokenFile + " cannot be read, or is empty. Make it with: openssl rand -hex 32");
  return {};
}

/// Reads the first line of the file. Others must not be able to read the file: with the secret, another program can
/// claim to be this server.
Result<void> readOpenIdSecret(Arguments& arguments) {
  namespace fs = std::filesystem;
  const std::string& file = arguments.openIdSecretFile;
  if (file.empty()) return {};
  std::error_code error;
  const fs::perms permissions = fs::status(file, error).permissions();
  std::ifstream in(file);
  if (error || !std::getline(in, arguments.options.openId.secret) || arguments.options.openId.secret.empty())
    return fail(file + " cannot be read, or its first line is empty. Write the client secret into its first line.");
  if ((permissions & (fs::perms::group_all | fs::perms::others_all)) != fs::perms::none)
    return fail("Other users can read or change " + file + ". Run as its owner: chmod 600 " + file);
  return {};
}

/// Fills a new database with an invented class, and says how to sign in.
Result<void> makeDemo(const CurriculumStore& store) {
  const auto curriculum = loadCurriculum("central_line");
  if (!curriculum) return tl::unexpected(curriculum.error());
  DemoClassPlan plan{.trainees = kDemoTrainees, .attempts = kDemoAttempts};
  plan.until_us =
      std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
          .count();
  if (auto made = makeDemoClass(store, *curriculum, plan, kDemoPassword); !made) return made;
  std::cout << "All people of this demonstration are made up. Sign in as " << kDemoInstructor << ", "
            << kDemoAdministrator << " or made-up-001, with the password '" << kDemoPassword << "'.\n";
  return {};
}

/// Waits until the process is asked to end. The signals must be blocked before any other thread begins.
void waitForEnd(const sigset_t& signals) {
  int signal = 0;
  sigwait(&signals, &signal);
}

Result<void> serve(Arguments& arguments) {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  if (auto ok = readListen(arguments); !ok) return ok;
  if (auto ok = readToken(arguments); !ok) return ok;
  if (auto ok = readOpenIdSecret(arguments); !ok) return ok;
  if (auto ok = web::checkOptions(arguments.options); !ok) return ok;
  if (arguments.demo == !arguments.database.empty())
    return fail("Name the database to serve, or give --demo for a made-up class, but not both.");
  std::optional<QTemporaryDir> folder;
  if (arguments.demo) {
    // In memory where the system has such a folder, so that the class is made at once.
    folder.emplace(QDir(QStringLiteral("/dev/shm")).exists() ? QStringLiteral("/dev/shm/insonate-XXXXXX") : QString());
    if (!folder->isValid())
      return fail("There is no folder for temporary files: " + folder->errorString().toStdString());
    arguments.database = folder->filePath(QStringLiteral("demonstration.db")).toStdString();
  }
  // A mistyped name would otherwise make a new, empty database.
  const bool isFile = !arguments.database.starts_with("postgresql://");
  if (!arguments.demo && isFile && !std::filesystem::exists(arguments.database))
    return fail(arguments.database +
                " does not exist. Name the file of an existing database, or make one with insonate-cli curriculum "
                "setup.");
  StoreServices services;
  services.recordings = arguments.recordings;
  // Passwords of made-up people need no protection against guessing, which costs 0.1 s for each.
  if (arguments.demo) services.passwordCost = PasswordCost::Minimum;
  const auto store = CurriculumStore::open(arguments.database, services);
  if (!store) return tl::unexpected(store.error());
  if (arguments.demo)
    if (auto made = makeDemo(*store); !made) return made;
  const auto server = web::WebServer::start(*store, arguments.options);
  if (!server) return tl::unexpected(server.error());
  std::cout << "Serving " << (arguments.demo ? "the demonstration" : store->place()) << " at " << server->url()
            << " (Ctrl+C ends)" << std::endl;
  waitForEnd(signals);
  return {};
}

void addOpenIdOptions(CLI::App& app, Arguments& arguments) {
  web::OpenIdOptions& openId = arguments.options.openId;
  app.add_option("--openid-issuer", openId.issuer,
                 "Address of the hospital's identity provider (OpenID Connect), by which users may sign in");
  app.add_option("--openid-client", openId.clientId, "Name under which the provider knows this server (client id)");
  app.add_option("--openid-secret-file", arguments.openIdSecretFile,
                 "File with the client secret in its first line, which only its owner may read (chmod 600)");
  app.add_option("--openid-name", openId.name, "Name of the provider on the sign-in page: 'Sign in with NAME'");
  app.add_option("--openid-authority", openId.authority,
                 "File (PEM) with the certificate of the authority that signed the provider's certificate; by default "
                 "the authorities that this computer trusts");
}

/// The names of the options are also those of the configuration file.
void addOptions(CLI::App& app, Arguments& arguments) {
  web::WebOptions& options = arguments.options;
  app.add_option("DATABASE,--database", arguments.database,
                 "Existing file, or postgresql://USER@HOST/DATABASE with the password in PGPASSWORD");
  app.add_option("--recordings", arguments.recordings,
                 "Folder for the recordings that workstations send; by default beside the database file; required with "
                 "a PostgreSQL database");
  app.add_option("--recordings-per-day", options.recordingsPerDay_GB,
                 "Maximum size in GB of the recordings that one workstation may send in 24 hours; further recordings "
                 "stay on the workstation and are sent later")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
  app.add_option(
      "--videos", options.videos,
      "Folder for the videos of attempts; by default 'videos' beside the folder of recordings. Several servers "
      "with one database need a common folder");
  app.add_option("--video-space", options.videoSpace_GB,
                 "Size of this folder in GB; above it, the videos that were watched longest ago are removed")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
  app.add_option(
      "--cases", options.cases,
      "Folder with the folders of cases. Workstations download its published cases, and videos of attempts on these "
      "cases are made from it");
  app.add_flag("--demo", arguments.demo,
               "Serve a made-up class, whose names and password are printed and whose data are deleted at the end");
  app.add_option("--listen", arguments.listen,
                 "Address or name of this computer, and port, at which the server listens; an IPv6 address is in "
                 "brackets: [::1]:8443")
      ->capture_default_str();
  app.add_option("--certificate", options.certificate, "File (PEM) with the certificate chain, for HTTPS");
  app.add_option("--key", options.key, "File (PEM) with the certificate's private key");
  app.add_flag("--behind-proxy", options.behindProxy,
               "A proxy on this computer receives HTTPS and passes requests on, with the header Host as it was sent");
  app.add_option("--proxy", options.proxies,
                 "Address of a proxy whose header X-Forwarded-For names the client; may be repeated");
  app.add_option("--audit-anchors", options.auditAnchors,
                 "File to which the server appends the end of the audit log each minute; best on another computer, so "
                 "that the owner of the database cannot change it");
  app.add_option("--monitoring-token-file", arguments.tokenFile,
                 "File with the secret by which other computers read /health and /metrics");
  addOpenIdOptions(app, arguments);
  app.set_config("--config", "", "File with these options, without their dashes: listen = \"127.0.0.1:8443\"");
  app.allow_config_extras(CLI::config_extras_mode::error);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Insonate's server shows levels, attempts and classes in a browser. It logs to the standard error."};
  app.set_version_flag("--version", std::string(INSONATE_VERSION));
  Arguments arguments;
  addOptions(app, arguments);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ConfigError& e) {
    std::cerr << "insonate-server: The configuration file cannot be used: " << e.what()
              << ". Its keys are the options that --help lists, without their dashes.\n";
    return 2;
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  arguments.options.log = standardLog();
  if (const auto served = serve(arguments); !served) {
    std::cerr << "insonate-server: " << served.error().message << '\n';
    return 1;
  }
  return 0;
}
