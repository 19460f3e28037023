#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <filesystem>
#include <string>

namespace insonate::ui {

/// Sign-in that one user keeps on this computer, in a file that only its owner can read: a token, or the generated
/// password of a user who has not chosen one.
struct KeptSignIn {
  std::string name{};               ///< for signing in; empty if nothing is kept
  std::string token{};              ///< of PeopleStore::staySignedIn()
  std::string generatedPassword{};  ///< empty if there is a token
};

/// Reads the file; returns an empty result if it is missing or damaged.
KeptSignIn readKeptSignIn(const std::filesystem::path& file);
Result<void> writeKeptSignIn(const std::filesystem::path& file, const KeptSignIn& kept);
/// Makes a token for the user and writes it to the file.
Result<void> keepSignedIn(const std::filesystem::path& file, const SignedIn& by);
/// Removes the file, if there is one.
void removeKeptSignIn(const std::filesystem::path& file);

}  // namespace insonate::ui
