#include "PostgresServer.h"

#include <netinet/in.h>
#include <pwd.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <utility>

namespace insonate::test {
namespace {
namespace fs = std::filesystem;

const fs::path kPrograms = "/usr/lib/postgresql/15/bin";
constexpr const char* kServerPassword = "a b/c@d:e";

/// Socket bound to a port of loopback; 0: a free one.
int boundTo(int port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0), on = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(std::uint16_t(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  ::bind(socket, reinterpret_cast<sockaddr*>(&address), sizeof address);
  return socket;
}

int freePort() {
  const int socket = boundTo(0);
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size);
  ::close(socket);
  return ntohs(address.sin_port);
}

}  // namespace

PostgresServer* PostgresServer::shared() {
  static const std::unique_ptr<PostgresServer> server(fs::exists(kPrograms / "initdb") ? new PostgresServer : nullptr);
  return server && server->process_ > 0 ? server.get() : nullptr;
}

PostgresServer::PostgresServer() : port_(freePort()) {
  std::ofstream(folder_ / "password") << kServerPassword;
  asUser_ = "setpriv --pdeathsig QUIT ";
  // PostgreSQL refuses to run as root.
  if (const passwd* nobody = ::getpwnam("nobody"); ::geteuid() == 0 && nobody) {
    asUser_ += "--reuid nobody --regid " + std::to_string(nobody->pw_gid) + " --clear-groups ";
    for (const fs::path& own : {folder_.path(), folder_ / "password"})
      if (::chown(own.c_str(), nobody->pw_uid, nobody->pw_gid) != 0) return;
  }
  if (run("initdb --no-sync -A scram-sha-256 -U insonate --locale=C.UTF-8 -E UTF8 --pwfile=" +
          (folder_ / "password").string() + " -D " + (folder_ / "data").string()) == 0)
    start();
  ::setenv("PGPASSWORD", kServerPassword, 1);
}

PostgresServer::~PostgresServer() {
  if (process_ <= 0) return;
  ::kill(process_, SIGQUIT);
  ::waitpid(process_, nullptr, 0);
}

int PostgresServer::run(const std::string& program) const {
  return std::system(("cd / && " + asUser_ + (kPrograms / program).string() + " >" + "/dev/null 2>&1").c_str());
}

void PostgresServer::start() {
  if (std::exchange(runs_, true)) return;
  if (silent_ >= 0) ::close(std::exchange(silent_, -1));
  const std::string command = "cd / && exec " + asUser_ + (kPrograms / "postgres").string() + " -F -D " +
                              (folder_ / "data").string() + " -c listen_addresses=127.0.0.1 -k " +
                              folder_.path().string() + " -p " + std::to_string(port_) + " >/dev/null 2>&1";
  process_ = ::fork();
  if (process_ == 0) {
    ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
    ::_exit(127);
  }
  for (int i = 0; i < 200; ++i) {
    if (run("pg_isready -q -h 127.0.0.1 -p " + std::to_string(port_)) == 0) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  ADD_FAILURE() << "PostgreSQL does not start";
}

void PostgresServer::crash() {
  ::kill(process_, SIGQUIT);
  ::waitpid(process_, nullptr, 0);
  runs_ = false;
}

void PostgresServer::fallSilent() {
  crash();
  silent_ = boundTo(port_);
  if (::listen(silent_, 16) != 0) ADD_FAILURE() << "the server's port is not free";
}

std::string PostgresServer::freshDatabase() {
  const std::string name = "store " + std::to_string(++databases_);
  if (run("createdb -h 127.0.0.1 -U insonate -p " + std::to_string(port_) + " '" + name + "'") != 0)
    ADD_FAILURE() << "no database";
  return "postgresql://insonate:a%20b%2Fc%40d%3Ae@127.0.0.1:" + std::to_string(port_) + "/store%20" +
         std::to_string(databases_);
}

}  // namespace insonate::test
