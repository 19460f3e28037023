#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/VerifiedEmail.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace insonate {

/// Sessions of people who use the pages of a server in a browser. A session is identified by a secret, which only the
/// browser keeps (in a cookie); the database keeps the SHA-256 hash of the secret. Since sessions are in the database,
/// each of several servers that share the database can answer each request. May be used on any thread.
class BrowserSessions {
 public:
  /// A session ends after this time without a request, and after kLongest_us in any case.
  static constexpr std::int64_t kLongestIdle_us = std::int64_t{60} * 60 * 1'000'000;
  static constexpr std::int64_t kLongest_us = std::int64_t{12} * 60 * 60 * 1'000'000;

  explicit BrowserSessions(CurriculumStore store) : store_(std::move(store)) {}

  /// Does what CurriculumStore::signIn() does, and also limits the wrong passwords from one network address of a
  /// browser, for all names together: 30 at once, then one each minute. If the address is "" (unknown), only the wrong
  /// passwords for each name are limited.
  Result<SignedIn> signIn(const std::string& name, const std::string& password, const std::string& address) const;
  /// Begins a session of a person who has just signed in with a password, and returns its secret: 64
  /// hexadecimal digits. Sessions that have ended are removed from the database.
  Result<std::string> begin(const SignedIn& by) const;
  /// Counts an attempt to sign in by an identity provider from a network address; call it before the provider's answer
  /// is verified. The limit is that of wrong passwords (signIn()), but the two are counted separately. Fails if there
  /// were too many attempts. An address of "" is not counted.
  Result<void> countSignInAttempt(const std::string& address) const;
  /// Begins a session of the only enabled account with this e-mail address, and returns its secret. Addresses may
  /// differ in the case of the letters A to Z only, since addresses that differ in other letters may belong to
  /// different mailboxes. The audit log gets an entry with the detail "OpenID". `address` must be the one that
  /// countSignInAttempt() received; the count of this address is reduced by one. The session requires no change of a
  /// first password, since its user did not use it. Fails with a sentence for the user if no account, several accounts
  /// or only disabled accounts have the e-mail address.
  Result<std::string> begin(const VerifiedEmail& email, const std::string& address) const;
  /// Tells whether a session was begun by an identity provider.
  static bool isByProvider(const std::string& secret);
  /// Returns the person of a session, with the permissions that this person has now; empty if the session is unknown or
  /// has ended, if another password was set since, or if the account is disabled. The time of the request is stored to
  /// the minute, unless the page made the request by itself (`isByUser` false): an open page must not keep a session
  /// alive. Fails only if the database cannot be read.
  Result<std::optional<SignedIn>> resume(const std::string& secret, bool isByUser = true) const;
  /// Returns the number of sessions that have not ended.
  Result<int> count() const;
  /// Ends a session; an unknown secret is no error.
  Result<void> end(const std::string& secret) const;
  /// Keeps the session with this secret after its person has changed the password. All other sessions of the person
  /// end.
  Result<void> keepAfterPasswordChange(const std::string& secret) const;

 private:
  CurriculumStore store_;
};

}  // namespace insonate
