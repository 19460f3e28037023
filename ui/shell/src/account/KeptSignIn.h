#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <filesystem>
#include <string>

namespace insonate::ui {

/// Data with which one user stays signed in on this computer, in a file that only its owner can read: a token, or the
/// generated password of a user who has not chosen one.
struct KeptSignIn {
  std::string name{};               ///< name for signing in; empty if no data are kept
  std::string token{};              ///< token that PeopleStore::staySignedIn() made
  std::string generatedPassword{};  ///< generated password; empty if there is a token
};

/// Reads the file; returns an empty result if it is missing or damaged.
KeptSignIn readKeptSignIn(const std::filesystem::path& file);
Result<void> writeKeptSignIn(const std::filesystem::path& file, const KeptSignIn& kept);
/// Makes a token for the user and writes it to the file.
Result<void> keepSignedIn(const std::filesystem::path& file, const SignedIn& by);
/// Removes the file, if there is one.
void removeKeptSignIn(const std::filesystem::path& file);

}  // namespace insonate::ui
