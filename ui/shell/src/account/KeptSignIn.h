#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <filesystem>
#include <string>

namespace insonate::ui {

/// Sign-in that one user keeps on this computer, in a file that only its owner can read.
struct KeptSignIn {
  std::string token{};     ///< of PeopleStore::staySignedIn(); empty if nobody is kept signed in
  std::string password{};  ///< the generated password, if the user has not chosen one
};

/// Reads the file; returns an empty result if it is missing or damaged.
KeptSignIn readKeptSignIn(const std::filesystem::path& file);
/// Makes a token for the user and writes the file.
Result<void> keepSignedIn(const std::filesystem::path& file, const SignedIn& by, const std::string& generatedPassword);
/// Removes the file. @returns whether there was one
bool removeKeptSignIn(const std::filesystem::path& file);

}  // namespace insonate::ui
