#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace insonate::cli {

/// Options that name the store and the user who signs in.
struct StoreOptions {
  std::string database, name, passwordFile;
};

/// Adds --database.
void addDatabaseOption(CLI::App& command, StoreOptions& options);
/// Adds --as and --password-file.
void addSignInOptions(CLI::App& command, StoreOptions& options);

/// Path of the user's own store file, in the folder that Qt's AppDataLocation gives the window.
std::filesystem::path usualStoreFile();
/// Address of the store: --database, else INSONATE_DATABASE, else the user's own file, which the window uses too.
std::string addressOf(const StoreOptions& options);
bool isServer(const std::string& address);
/// Returns services that keep recordings of a server's attempts in a folder of the user, as the window does.
StoreServices servicesFor(const std::string& address);
/// Opens the store; creates it and its folder if it does not exist.
Result<CurriculumStore> openOrMakeStore(const StoreOptions& options);
/// Fails if the store is a file that does not exist.
Result<void> checkThere(const StoreOptions& options);
/// Opens the store; fails if it does not exist.
Result<CurriculumStore> openStore(const StoreOptions& options);
/// Reads the password of the user who signs in.
Result<std::string> readOwnPassword(const StoreOptions& options);
/// Signs the user in. Fails also if the user must choose a new password first.
Result<SignedIn> signIn(const StoreOptions& options);

/// Option for a new password, read from --new-password-file or INSONATE_NEW_PASSWORD, or asked for twice.
struct NewPasswordOption {
  std::string file;

  void addTo(CLI::App& command);
  Result<std::string> read(const std::string& prompt) const;
};

}  // namespace insonate::cli
