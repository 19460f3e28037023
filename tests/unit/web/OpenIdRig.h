#pragma once

#include "WebRig.h"
#include "http/HttpServer.h"

#include <nlohmann/json.hpp>

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

struct _cjose_jwk_int;

namespace insonate::test {

/// A key with which a test signs tokens.
class TestKey {
 public:
  enum class Kind { Rsa, Curve };
  TestKey(Kind kind, std::string id);
  /// A key for HMAC, of these bytes.
  explicit TestKey(const std::string& bytes);

  /// The public part, as a JSON web key.
  nlohmann::json open() const;
  /// A token (JWS, compact form).
  std::string sign(const std::string& algorithm, const std::string& content) const;

  /// Keys that the tests of a program share, since they take long to make.
  static const TestKey& rsa();
  static const TestKey& otherRsa();  ///< has the id of rsa()
  static const TestKey& curve();

 private:
  std::shared_ptr<_cjose_jwk_int> key_;
  std::string id_;
};

/// Encodes bytes as tokens do.
std::string base64Url(const std::string& bytes);

/// An identity provider of a made-up hospital: a web server on this computer.
class MadeUpProvider {
 public:
  /// `options`: certificate and key, if it shall use HTTPS.
  explicit MadeUpProvider(web::WebOptions options = {});

  /// Options of a server that uses this provider.
  web::OpenIdOptions options() const;
  /// Signs the user in, as a browser would that was sent to `address`; returns the address to which the browser is sent
  /// back, without its scheme and host.
  std::string signIn(const std::string& address);

  std::string issuer;
  nlohmann::json metadata;
  nlohmann::json keys;                               ///< answer of the address of keys
  nlohmann::json claims = nlohmann::json::object();  ///< replaces claims of the next tokens; null removes a claim
  std::function<std::string(const std::string& content)> sign;
  std::map<std::string, web::Response> answers;  ///< answers that replace others, by path
  std::atomic<int> keyRequests = 0, tokenRequests = 0;

 private:
  struct Pending {
    std::string nonce, challenge, returnAddress;
  };
  web::Response answer(const web::Request& request);
  web::Response token(const web::Request& request);
  bool knowsClient(const web::Request& request) const;

  std::map<std::string, Pending> codes_;
  int lastCode_ = 0;
  std::unique_ptr<web::HttpServer> server_;
};

/// A browser that keeps cookies.
class TestBrowser {
 public:
  explicit TestBrowser(const web::Site& site, std::string address = "10.0.0.7")
      : site_(&site), address_(std::move(address)) {}

  web::Response get(const std::string& path);
  web::Response post(const std::string& path, web::Fields form);
  /// Opens the sign-in by the provider and signs in there; returns the address for the return.
  std::string atProvider(MadeUpProvider& provider, const std::string& next = "/me");
  /// Does the whole sign-in, and returns the last answer.
  web::Response signIn(MadeUpProvider& provider, const std::string& next = "/me") {
    return get(atProvider(provider, next));
  }
  bool isSignedIn() { return get("/me").status == 200; }

  std::map<std::string, std::string> cookies;

 private:
  web::Response ask(web::Request request);
  const web::Site* site_;
  std::string address_;
};

}  // namespace insonate::test
