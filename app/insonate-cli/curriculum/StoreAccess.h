#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>

namespace insonate::cli {

/// Options: the store and the user who signs in.
struct StoreOptions {
  std::string database, name, passwordFile;
};

/// --database
void addDatabaseOption(CLI::App& command, StoreOptions& options);
/// --as and --password-file.
void addSignInOptions(CLI::App& command, StoreOptions& options);

/// The user's own, as Qt's AppDataLocation has it for the window.
std::filesystem::path usualStoreFile();
/// Address of the store: --database, else INSONATE_DATABASE, else the user's own file, which the window uses too.
std::string addressOf(const StoreOptions& options);
bool isServer(const std::string& address);
/// Keeps recordings of a server's attempts in a folder of the user, as the window does.
StoreServices servicesFor(const std::string& address);
/// Made where there is none, with its folder.
Result<CurriculumStore> openOrMakeStore(const StoreOptions& options);
/// Fails where there is no store's file yet.
Result<void> checkThere(const StoreOptions& options);
/// Fails where there is none yet.
Result<CurriculumStore> openStore(const StoreOptions& options);
/// Reads the password of the user who signs in.
Result<std::string> readOwnPassword(const StoreOptions& options);
/// Fails, too, where they have to choose a password first.
Result<SignedIn> signIn(const StoreOptions& options);

/// A password to be set: --new-password-file, INSONATE_NEW_PASSWORD, or asked for twice.
struct NewPasswordOption {
  std::string file;

  void addTo(CLI::App& command);
  Result<std::string> read(const std::string& prompt) const;
};

}  // namespace insonate::cli
