#include "StoreAccess.h"

#include "../Commands.h"
#include "Password.h"

#include <cstdlib>
#include <filesystem>

namespace insonate::cli {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* variable) {
  const char* value = std::getenv(variable);
  return value ? value : "";
}

}  // namespace

void addDatabaseOption(CLI::App& command, StoreOptions& options) {
  command
      .add_option("--database", options.database,
                  "Database: a file, or postgresql://USER@HOST/DATABASE; by default the environment variable "
                  "INSONATE_DATABASE, or else the database that the window uses")
      ->check(notEmpty());
}

void addSignInOptions(CLI::App& command, StoreOptions& options) {
  command.add_option("--as", options.name, "Name of the user who signs in")->required()->check(notEmpty());
  command
      .add_option("--password-file", options.passwordFile,
                  "File whose first line is the password (/dev/fd/N for a file descriptor); by default the environment "
                  "variable INSONATE_PASSWORD, or else the command asks for it")
      ->check(notEmpty());
}

fs::path usualStoreFile() {
  const fs::path home = environment("HOME"), data = environment("XDG_DATA_HOME");
  return (data.is_absolute() ? data : home / ".local/share") / "Insonate/insonate/curriculum.sqlite";
}

std::string addressOf(const StoreOptions& options) {
  if (!options.database.empty()) return options.database;
  const std::string named = environment("INSONATE_DATABASE");
  return named.empty() ? usualStoreFile().string() : named;
}

bool isServer(const std::string& address) {
  return address.starts_with("postgresql://") || address.starts_with("postgres://");
}

StoreServices servicesFor(const std::string& address) {
  StoreServices services;
  if (isServer(address)) services.recordings = usualStoreFile().parent_path() / "server.recordings";
  return services;
}

Result<CurriculumStore> openOrMakeStore(const StoreOptions& options) {
  const std::string address = addressOf(options);
  std::error_code error;  // CurriculumStore says what is wrong with the folder
  if (!isServer(address)) fs::create_directories(fs::absolute(address, error).parent_path(), error);
  return CurriculumStore::open(address, servicesFor(address));
}

Result<void> checkThere(const StoreOptions& options) {
  const std::string address = addressOf(options);
  std::error_code error;
  if (isServer(address) || fs::exists(address, error)) return {};
  return fail("There is no store of people and attempts at " + address +
              ". Make a store with 'insonate-cli curriculum setup', or name another store with --database.");
}

Result<CurriculumStore> openStore(const StoreOptions& options) {
  if (auto there = checkThere(options); !there) return tl::unexpected(there.error());
  StoreServices services = servicesFor(addressOf(options));
  services.opensReadOnly = true;
  return CurriculumStore::open(addressOf(options), services);
}

Result<std::string> readOwnPassword(const StoreOptions& options) {
  return readPassword({options.passwordFile, "INSONATE_PASSWORD", "Password of " + options.name});
}

Result<SignedIn> signIn(const StoreOptions& options) {
  const auto store = openStore(options);
  if (!store) return tl::unexpected(store.error());
  const auto password = readOwnPassword(options);
  if (!password) return tl::unexpected(password.error());
  auto by = store->signIn(options.name, *password);
  if (by && by->mustChangePassword())
    return fail(
        "Another user has set this password. Choose your own password first: insonate-cli curriculum people password "
        "--as " +
        options.name);
  return by;
}

void NewPasswordOption::addTo(CLI::App& command) {
  command
      .add_option("--new-password-file", file,
                  "File whose first line is the new password; by default the environment variable "
                  "INSONATE_NEW_PASSWORD, or else the command asks for it")
      ->check(notEmpty());
}

Result<std::string> NewPasswordOption::read(const std::string& prompt) const {
  return readPassword({file, "INSONATE_NEW_PASSWORD", prompt, true});
}

}  // namespace insonate::cli
