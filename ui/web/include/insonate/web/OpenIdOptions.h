#pragma once

#include <filesystem>
#include <string>

namespace insonate::web {

/// Identity provider of a hospital, by which users sign in with OpenID Connect. All fields empty: users sign in with
/// their password only.
struct OpenIdOptions {
  std::string issuer{};    ///< address of the provider: https://, or http:// at a loopback address
  std::string clientId{};  ///< name under which the provider knows this server
  std::string secret{};    ///< secret that the provider has assigned to this server
  std::string name{};      ///< name of the provider for users: "Sign in with NAME"
  /// File (PEM) with the certificate of the authority that signed the provider's certificate; empty: the authorities
  /// that this computer trusts.
  std::filesystem::path authority{};
};

}  // namespace insonate::web
