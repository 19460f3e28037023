#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace insonate::cli {

/// Command-line options that name the curriculum database and the user who signs in.
struct StoreOptions {
  std::string database, name, passwordFile;
};

/// Adds the option --database to a command.
void addDatabaseOption(CLI::App& command, StoreOptions& options);
/// Adds the options for signing in, --as and --password-file, to a command.
void addSignInOptions(CLI::App& command, StoreOptions& options);

/// Returns the path of the user's own curriculum database, in the folder QStandardPaths::AppDataLocation of the window.
std::filesystem::path usualStoreFile();
/// Returns the address of the curriculum database: --database, else INSONATE_DATABASE, else usualStoreFile().
std::string addressOf(const StoreOptions& options);
bool isServer(const std::string& address);
/// Returns the services with which a database is opened; recordings of a server's attempts are kept in a folder of the
/// user, as by the window.
StoreServices servicesFor(const std::string& address);
/// Opens the curriculum database; creates the database and its folder if it does not exist.
Result<CurriculumStore> openOrMakeStore(const StoreOptions& options);
/// Fails if the curriculum database is a file that does not exist.
Result<void> checkThere(const StoreOptions& options);
/// Opens the curriculum database; fails if it does not exist.
Result<CurriculumStore> openStore(const StoreOptions& options);
/// Reads the password of the user who signs in.
Result<std::string> readOwnPassword(const StoreOptions& options);
/// Signs the user in. Fails also if the user must choose a new password first.
Result<SignedIn> signIn(const StoreOptions& options);

/// Option for a new password, which is read from --new-password-file or INSONATE_NEW_PASSWORD, or asked for twice on
/// the terminal.
struct NewPasswordOption {
  std::string file;

  void addTo(CLI::App& command);
  Result<std::string> read(const std::string& prompt) const;
};

}  // namespace insonate::cli
