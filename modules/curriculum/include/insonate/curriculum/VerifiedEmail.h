#pragma once

#include <string>
#include <utility>

namespace insonate {
namespace web {
class IdToken;
}

/// E-mail address of a user whom the identity provider of a hospital has signed in, and whose address the provider has
/// verified. BrowserSessions begins a session for this address without a password. Therefore only web::IdToken can make
/// an object of this class, after it has verified the provider's signature. May be used on any thread.
class VerifiedEmail {
 public:
  const std::string& text() const { return text_; }

 private:
  friend class web::IdToken;
  explicit VerifiedEmail(std::string text) : text_(std::move(text)) {}

  std::string text_;
};

}  // namespace insonate
